// SPDX-License-Identifier: MIT
#include "search/result_tables.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "base/hash.h"
#include "search/objectives.h"

namespace stig::search {
namespace {

constexpr const char* kFormat = "3";

std::string value_columns(std::string_view after) {
  std::string columns;
  for (const Objective& objective : objectives()) {
    columns += fmt::format(", \"{}\"{}", objective.name, after);
  }
  return columns;
}

}  // namespace

std::uint64_t from_hex(const std::string& text) {
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, 16);
  return value;
}

std::string meta(SqliteFile& file, const std::string& key) {
  SqliteStatement ask(file, "SELECT value FROM meta WHERE key = ?");
  return ask.bind(std::string_view(key)).step() ? ask.text(0) : std::string();
}

void set_meta(SqliteFile& file, std::string_view key, std::string_view value) {
  SqliteStatement put(file, "INSERT INTO meta VALUES(?, ?)");
  put.bind(key).bind(value).step();
}

std::uint64_t evaluated_of(SqliteFile& file) {
  const std::string text = meta(file, "evaluated");
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string slice_text(const BatchSlice& slice) {
  return slice.of == 1 ? std::string() : fmt::format("{}/{}", slice.number, slice.of);
}

bool has_tables(SqliteFile& file) {
  SqliteStatement ask(file, "SELECT count(*) FROM sqlite_master");
  return ask.step() && ask.integer(0) > 0;
}

void check_format(SqliteFile& file) {
  SqliteStatement ask(file, "SELECT count(*) FROM sqlite_master WHERE name = 'individuals'");
  if (!ask.step() || ask.integer(0) == 0) throw SqliteFailure{"it has no results of a search"};
  if (meta(file, "format") != kFormat) {
    throw SqliteFailure{"its results are of another version of the program"};
  }
}

std::string schema() {
  return "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL);\n"
         "CREATE TABLE structures(hash TEXT PRIMARY KEY, times INTEGER NOT NULL, bricks TEXT NOT "
         "NULL);\n"
         "CREATE TABLE individuals(id INTEGER PRIMARY KEY, origin TEXT NOT NULL, parent INTEGER, "
         "other_parent INTEGER, structure TEXT NOT NULL REFERENCES structures(hash), score REAL "
         "NOT "
         "NULL, genome TEXT NOT NULL" +
         value_columns(" REAL NOT NULL") +
         ");\n"
         "CREATE INDEX by_structure ON individuals(structure, score DESC, id);\n"
         "CREATE TABLE batches(evaluated INTEGER PRIMARY KEY, best REAL NOT NULL, mean REAL NOT "
         "NULL, deviation REAL NOT NULL, structures INTEGER NOT NULL);\n"
         "CREATE VIEW finds AS SELECT i.*, s.times FROM individuals i JOIN structures s ON "
         "s.hash = i.structure WHERE i.id = (SELECT id FROM individuals WHERE structure = s.hash "
         "ORDER BY score DESC, id LIMIT 1);\n"
         "CREATE VIEW parents AS SELECT id, parent FROM individuals WHERE parent IS NOT NULL "
         "UNION SELECT id, other_parent FROM individuals WHERE other_parent IS NOT NULL;\n";
}

void create_tables(SqliteFile& file, const SearchPlan& plan, const BatchSlice& slice) {
  SqliteTransaction all(file, SqliteTransaction::Use::write);
  if (has_tables(file)) return;  // another search was first
  file.run(schema());
  set_meta(file, "format", kFormat);
  set_meta(file, "plan", to_hex(plan_hash(plan)));
  set_meta(file, "name", plan.name);
  set_meta(file, "method", std::string(to_string(plan.method)));
  set_meta(file, "seed", std::to_string(plan.seed));
  set_meta(file, "evaluated", "0");
  if (slice.of > 1) set_meta(file, "slice", slice_text(slice));
  all.commit();
}

std::string find_columns() {
  return "id, origin, parent, other_parent, score, structure, genome" + value_columns("");
}

std::size_t find_column_count() { return 7 + objectives().size(); }

std::string insert_individual() {
  std::string marks;
  for (std::size_t k = 0; k < find_column_count(); ++k) marks += k == 0 ? "?" : ", ?";
  return "INSERT INTO individuals(" + find_columns() + ") VALUES(" + marks + ")";
}

/// Reading must not make a file.
SqliteFile open_to_read(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw SqliteFailure{"there is no such file"};
  return SqliteFile(path, SqliteFile::Use::read);
}

std::string about(const std::string& path, const SqliteFailure& failure) {
  return fmt::format("{}: {}", path, failure.text);
}

}  // namespace stig::search
