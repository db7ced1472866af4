// SPDX-License-Identifier: MIT
// What goes into the tables and what comes out.
#include "search/result_file.h"

#include <fmt/format.h>

#include <cassert>
#include <charconv>
#include <cstdlib>

#include "base/hash.h"
#include "lattice/loaded_structure.h"
#include "search/objectives.h"
#include "search/result_tables.h"

namespace stig::search {
namespace {

std::string bricks_text(const std::vector<PlacedBrick>& bricks) {
  std::string text = "[";
  for (const PlacedBrick& b : bricks) {
    text +=
        fmt::format("{}[{},{},{},{}]", text.size() > 1 ? "," : "", b.at.x, b.at.y, b.at.z, b.brick);
  }
  return text + "]";
}

/// What bricks_text wrote: numbers, four a brick, between whatever parts them. The file may be
/// anyone's.
std::optional<std::vector<PlacedBrick>> bricks_in(const std::string& text) {
  std::vector<std::int64_t> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end;) {
    std::int64_t value = 0;
    const auto [rest, problem] = std::from_chars(at, end, value);
    if (problem == std::errc()) numbers.push_back(value);
    at = problem == std::errc() ? rest : at + 1;
  }
  if (numbers.empty() || numbers.size() % 4 != 0) return std::nullopt;
  std::vector<PlacedBrick> bricks;
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(numbers[i + k]) > kMaxCoordinate) return std::nullopt;
    }
    if (numbers[i + 3] < 1 || numbers[i + 3] > kMostGenomeColours) return std::nullopt;
    const auto at = [&](std::size_t k) { return static_cast<std::int32_t>(numbers[i + k]); };
    bricks.push_back({Cell{at(0), at(1), at(2)}, static_cast<Colour>(numbers[i + 3])});
  }
  if (find_problem(bricks)) return std::nullopt;
  return bricks;
}

StoredFind find_in(const SqliteStatement& row) {
  StoredFind find;
  find.id = row.integer(0);
  find.origin = row.text(1);
  find.parent = row.integer_if_any(2);
  find.other_parent = row.integer_if_any(3);
  find.score = row.number(4);
  find.structure = from_hex(row.text(5));
  auto genome = read_genome(row.text(6));
  if (!genome)
    throw SqliteFailure{fmt::format("the genome of individual {} cannot be read", find.id)};
  find.genome = std::move(*genome);
  for (std::size_t k = 0; k < objectives().size(); ++k) {
    find.values.push_back(row.number(static_cast<int>(7 + k)));
  }
  return find;
}

/// Origins live as long as the program.
std::string_view origin_named(const std::string& name) {
  for (const std::string_view known : {"mutated", "mended", "crossed"}) {
    if (name == known) return known;
  }
  return "drawn";
}

Individual individual_of(StoredFind find) {
  Individual one;
  one.id = find.id;
  one.origin = origin_named(find.origin);
  one.parent = find.parent;
  one.other_parent = find.other_parent;
  one.genome = std::move(find.genome);
  one.structure = find.structure;
  one.values = std::move(find.values);
  one.score = find.score;
  return one;
}

/// Everything that was kept, and how often each structure was built.
void load(SqliteFile& file, FindArchive& archive) {
  std::map<std::uint64_t, std::uint64_t> shown;
  SqliteStatement rows(file, "SELECT " + find_columns() + " FROM individuals ORDER BY id");
  while (rows.step()) {
    Individual one = individual_of(find_in(rows));
    ++shown[one.structure];
    archive.offer(std::move(one));
  }
  SqliteStatement structures(file, "SELECT hash, times FROM structures");
  while (structures.step()) {
    const std::uint64_t hash = from_hex(structures.text(0));
    archive.count(hash, structures.integer(1) - shown[hash]);
  }
}

}  // namespace

struct ResultFile::Connection {
  std::string path;
  SqliteFile file;
  std::uint64_t evaluated = 0;

  void add_individual(SqliteStatement& put, const Individual& one) {
    put.bind(one.id).bind(one.origin).bind(one.parent).bind(one.other_parent);
    put.bind(one.score).bind(std::string_view(to_hex(one.structure)));
    put.bind(std::string_view(genome_text(one.genome)));
    for (const double value : one.values) put.bind(value);
    put.step();
    put.again();
  }

  void add_structures(const SearchBatch& batch, const FindArchive& archive) {
    SqliteStatement put(
        file,
        "INSERT INTO structures VALUES(?, ?, ?) ON CONFLICT(hash) DO UPDATE SET times = "
        "times + excluded.times");
    std::map<std::uint64_t, const Individual*> first;
    for (std::size_t i = batch.first_kept; i < archive.kept().size(); ++i) {
      first.emplace(archive.kept()[i].structure, &archive.kept()[i]);
    }
    for (const auto& [hash, times] : batch.built) {
      const auto it = first.find(hash);
      // A structure that is new has been kept; of the others the bricks are in the file.
      const std::string bricks = it == first.end() ? "[]" : bricks_text(it->second->bricks);
      put.bind(std::string_view(to_hex(hash))).bind(times).bind(std::string_view(bricks)).step();
      put.again();
    }
  }

  void advance(const SearchBatch& batch, std::size_t structures) {
    SqliteStatement move(file, "UPDATE meta SET value = ? WHERE key = 'evaluated' AND value = ?");
    move.bind(std::string_view(std::to_string(batch.evaluated)));
    move.bind(std::string_view(std::to_string(evaluated))).step();
    if (file.changes() != 1) throw SqliteFailure{"another search has written to it meanwhile"};
    SqliteStatement put(file, "INSERT INTO batches VALUES(?, ?, ?, ?, ?)");
    put.bind(batch.until).bind(batch.best).bind(batch.mean).bind(batch.deviation);
    put.bind(std::uint64_t{structures}).step();
  }
};

ResultFile::ResultFile(std::unique_ptr<Connection> connection)
    : connection_(std::move(connection)) {}
ResultFile::~ResultFile() = default;
ResultFile::ResultFile(ResultFile&&) noexcept = default;
ResultFile& ResultFile::operator=(ResultFile&&) noexcept = default;

std::optional<ResultFile> ResultFile::go_on(const std::string& path, const SearchPlan& plan,
                                            SearchState& state, std::string& error) {
  try {
    std::unique_ptr<Connection> connection(
        new Connection{path, SqliteFile(path, SqliteFile::Use::write_or_create), 0});
    SqliteFile& file = connection->file;
    if (has_tables(file)) check_format(file);
    file.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    if (!has_tables(file)) create_tables(file, plan, state.slice);
    if (meta(file, "plan") != to_hex(plan_hash(plan))) {
      throw SqliteFailure{"its results are of another plan"};
    }
    if (meta(file, "slice") != slice_text(state.slice)) {
      throw SqliteFailure{"its results are of another slice of the search"};
    }
    // Another search may be adding a batch: what is counted and what was kept must agree.
    const SqliteTransaction all(file, SqliteTransaction::Use::read);
    load(file, state.archive);
    state.evaluated = connection->evaluated = evaluated_of(file);
    return ResultFile(std::move(connection));
  } catch (const SqliteFailure& failure) {
    error = about(path, failure);
    return std::nullopt;
  }
}

bool ResultFile::add(const SearchBatch& batch, const FindArchive& archive, std::string& error) {
  try {
    SqliteTransaction all(connection_->file, SqliteTransaction::Use::write);
    connection_->advance(batch, archive.structures());
    connection_->add_structures(batch, archive);
    SqliteStatement put(connection_->file, insert_individual());
    for (std::size_t i = batch.first_kept; i < archive.kept().size(); ++i) {
      connection_->add_individual(put, archive.kept()[i]);
    }
    all.commit();
    connection_->evaluated = batch.evaluated;
    return true;
  } catch (const SqliteFailure& failure) {
    error = about(connection_->path, failure);
    return false;
  }
}

std::optional<StoredResults> read_results(const std::string& path, std::size_t most,
                                          std::string& error) {
  try {
    SqliteFile file = open_to_read(path);
    const SqliteTransaction all(file, SqliteTransaction::Use::read);
    check_format(file);
    StoredResults out;
    out.name = meta(file, "name");
    out.plan = from_hex(meta(file, "plan"));
    out.evaluated = evaluated_of(file);
    FindArchive archive{SearchPlan{}};
    load(file, archive);
    out.structures = archive.structures();
    out.kept = archive.kept().size();
    out.content = archive.content_hash();
    SqliteStatement rows(
        file, "SELECT " + find_columns() + ", times FROM finds ORDER BY score DESC, id LIMIT ?");
    rows.bind(std::uint64_t{most});
    while (rows.step()) {
      out.finds.push_back(find_in(rows));
      out.finds.back().times = rows.integer(static_cast<int>(7 + objectives().size()));
    }
    SqliteStatement batches(
        file,
        "SELECT evaluated, structures, best, mean, deviation FROM batches ORDER BY evaluated");
    while (batches.step()) {
      out.batches.push_back({batches.integer(0), batches.integer(1), batches.number(2),
                             batches.number(3), batches.number(4)});
    }
    return out;
  } catch (const SqliteFailure& failure) {
    error = about(path, failure);
    return std::nullopt;
  }
}

std::optional<std::vector<PlacedBrick>> read_bricks(const std::string& path,
                                                    std::uint64_t structure, std::string& error) {
  try {
    SqliteFile file = open_to_read(path);
    const SqliteTransaction all(file, SqliteTransaction::Use::read);
    check_format(file);
    SqliteStatement row(file, "SELECT bricks FROM structures WHERE hash = ?");
    const std::string hash = to_hex(structure);
    if (!row.bind(std::string_view(hash)).step())
      throw SqliteFailure{"it has no structure " + hash};
    auto bricks = bricks_in(row.text(0));
    if (!bricks) throw SqliteFailure{"the bricks of structure " + hash + " cannot be read"};
    return bricks;
  } catch (const SqliteFailure& failure) {
    error = about(path, failure);
    return std::nullopt;
  }
}

std::optional<StoredFind> read_find(const std::string& path, std::uint64_t id, std::string& error) {
  try {
    SqliteFile file = open_to_read(path);
    check_format(file);
    SqliteStatement row(file, "SELECT " + find_columns() + " FROM individuals WHERE id = ?");
    if (!row.bind(id).step()) throw SqliteFailure{fmt::format("it has no individual {}", id)};
    return find_in(row);
  } catch (const SqliteFailure& failure) {
    error = about(path, failure);
    return std::nullopt;
  }
}

}  // namespace stig::search
