// SPDX-License-Identifier: MIT
// The tables of a file of results, as docs/search.md has them. Private to this folder. Hashes are
// text, since SQLite's integers have a sign and other programs' numbers 53 bits.
#pragma once

#include <cstdint>
#include <string>

#include "search/search_plan.h"
#include "search/sqlite_file.h"
#include "search/uses.h"

namespace stig::search {

/// A hash as it stands in a table.
std::uint64_t from_hex(const std::string& text);

/// The value of a key of `meta`; empty: it has none.
std::string meta(SqliteFile& file, const std::string& key);
/// Adds a key that is not there.
void set_meta(SqliteFile& file, std::string_view key, std::string_view value);
std::uint64_t evaluated_of(SqliteFile& file);  ///< 0 where that is no number

/// "2/3"; empty: the whole search.
std::string slice_text(const BatchSlice& slice);

bool has_tables(SqliteFile& file);
/// Throws where these are no results, or those of another version.
void check_format(SqliteFile& file);
/// The schema alone; its tables are empty.
std::string schema();
/// The tables of a search that begins, unless another search was first.
void create_tables(SqliteFile& file, const SearchPlan& plan, const BatchSlice& slice);

/// Columns of `individuals`, parted by commas, and how many they are.
std::string find_columns();
std::size_t find_column_count();
/// A statement with a question mark for each of these.
std::string insert_individual();

/// Reading does not make a file.
SqliteFile open_to_read(const std::string& path);

/// What a user is told.
std::string about(const std::string& path, const SqliteFailure& failure);

}  // namespace stig::search
