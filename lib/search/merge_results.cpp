// SPDX-License-Identifier: MIT
// An individual that is better than all before it in the whole search is so in its slice as well:
// the slices' individuals are more than enough, and those that another slice was ahead of go.
// Structures are counted by each slice; their bricks are those of the first that built them.
#include "search/merge_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "search/result_tables.h"

namespace stig::search {
namespace {

/// "2/3" with 1 <= 2 <= 3; "" is the only slice of a search in one piece.
BatchSlice slice_in(const std::string& text) {
  if (text.empty()) return {};
  BatchSlice slice{0, 0};
  const char* const end = text.data() + text.size();
  const auto [slash, problem] = std::from_chars(text.data(), end, slice.number);
  if (problem == std::errc() && slash != end && *slash == '/') {
    std::from_chars(slash + 1, end, slice.of);
  }
  if (slice.number < 1 || slice.number > slice.of) throw SqliteFailure{"its slice is none"};
  return slice;
}

class Merger {
 public:
  Merger() : out_(SqliteFile::kInMemory, SqliteFile::Use::write_or_create) {
    out_.run(schema());
    // As structures, with the individual that built one first.
    out_.run(
        "CREATE TEMP TABLE built(hash TEXT NOT NULL, times INTEGER NOT NULL, bricks TEXT NOT "
        "NULL, first INTEGER NOT NULL)");
  }

  void add(SqliteFile& file) {
    const SqliteTransaction all(file, SqliteTransaction::Use::read);
    check_format(file);
    const BatchSlice slice = slice_in(meta(file, "slice"));
    if (seen_.empty()) {
      for (const char* key : {"format", "plan", "name", "method", "seed"}) {
        set_meta(out_, key, meta(file, key));
      }
      of_ = slice.of;
    }
    if (meta(file, "plan") != meta(out_, "plan") || slice.of != of_) {
      throw SqliteFailure{"its results are of another plan, or of other slices"};
    }
    if (std::find(seen_.begin(), seen_.end(), slice.number) != seen_.end()) {
      throw SqliteFailure{fmt::format("slice {} of {} is given twice", slice.number, slice.of)};
    }
    seen_.push_back(slice.number);
    const int columns = static_cast<int>(find_column_count());
    copy(file, "SELECT " + find_columns() + " FROM individuals", insert_individual(), columns);
    copy(file, "SELECT evaluated, best, mean, deviation, structures FROM batches",
         "INSERT INTO batches VALUES(?, ?, ?, ?, ?)", 5);
    copy(
        file,
        "SELECT hash, times, bricks, (SELECT min(id) FROM individuals WHERE structure = hash) FROM "
        "structures",
        "INSERT INTO built VALUES(?, ?, ?, ?)", 4);
  }

  std::string bytes() {
    if (seen_.size() != of_) {
      throw SqliteFailure{fmt::format("{} of {} slices are given", seen_.size(), of_)};
    }
    // The bricks stand in the row that the minimum is of.
    out_.run(
        "INSERT INTO structures SELECT hash, times, bricks FROM (SELECT hash, sum(times) AS "
        "times, bricks, min(first) FROM built GROUP BY hash ORDER BY hash)");
    out_.run(
        "DELETE FROM individuals AS late WHERE EXISTS (SELECT 1 FROM individuals AS early WHERE "
        "early.structure = late.structure AND early.score >= late.score AND early.id < late.id)");
    set_meta(out_, "evaluated", std::to_string(finish_batches()));
    out_.run("VACUUM");
    return out_.bytes();
  }

 private:
  void copy(SqliteFile& from, const std::string& rows, const std::string& into, int columns) {
    SqliteTransaction all(out_, SqliteTransaction::Use::write);
    SqliteStatement row(from, rows), put(out_, into);
    while (row.step()) {
      put.bind_row(row, columns).step();
      put.again();
    }
    all.commit();
  }

  std::vector<std::uint64_t> numbers(const std::string& query) {
    std::vector<std::uint64_t> out;
    SqliteStatement row(out_, query);
    while (row.step()) out.push_back(row.integer(0));
    return out;
  }

  /// Structures at the end of each batch are counted over all slices; the evaluations in all.
  std::uint64_t finish_batches() {
    const auto ends = numbers("SELECT evaluated FROM batches ORDER BY evaluated");
    const auto firsts =
        numbers("SELECT min(id) AS first FROM individuals GROUP BY structure ORDER BY first");
    SqliteTransaction all(out_, SqliteTransaction::Use::write);
    SqliteStatement put(out_, "UPDATE batches SET structures = ? WHERE evaluated = ?");
    std::uint64_t evaluated = 0;
    for (const std::uint64_t end : ends) {
      // All batches have the size of the first.
      if (end != evaluated + ends.front()) {
        throw SqliteFailure{
            fmt::format("evaluations {} to {} are in none of these: one slice is "
                        "behind the others",
                        evaluated, evaluated + ends.front() - 1)};
      }
      evaluated = end;
      const auto known = std::lower_bound(firsts.begin(), firsts.end(), end) - firsts.begin();
      put.bind(static_cast<std::uint64_t>(known)).bind(end).step();
      put.again();
    }
    all.commit();
    return evaluated;
  }

  SqliteFile out_;
  std::uint64_t of_ = 1;  ///< slices of the search
  std::vector<std::uint64_t> seen_;
};

}  // namespace

bool is_sqlite_file(const std::string& path) {
  constexpr std::string_view kBeginning("SQLite format 3\0", 16);
  std::string head(kBeginning.size(), ' ');
  std::ifstream file(path, std::ios::binary);
  return file.read(head.data(), static_cast<std::streamsize>(head.size())) && head == kBeginning;
}

std::optional<std::string> merge_results(const std::vector<std::string>& slices,
                                         std::string& error) {
  std::string at;
  try {
    Merger merger;
    for (const std::string& path : slices) {
      at = path;
      SqliteFile file = open_to_read(path);
      merger.add(file);
    }
    at = fmt::format("{}", fmt::join(slices, ", "));
    return merger.bytes();
  } catch (const SqliteFailure& failure) {
    error = about(at, failure);
    return std::nullopt;
  }
}

}  // namespace stig::search
