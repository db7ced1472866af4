// SPDX-License-Identifier: MIT
// The results of a search's slices as those of the search in one piece.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "search/uses.h"

namespace stig::search {

/// Has this file the beginning that all SQLite files have?
bool is_sqlite_file(const std::string& path);

/// The bytes of an SQLite file whose tables hold, row by row, what a search that was not sliced has
/// after as many batches. Nothing with `error` set: slices of other plans, not all of them or one
/// twice, or one that is behind the others. Slices may be anyone's files; none is written to.
std::optional<std::string> merge_results(const std::vector<std::string>& slices,
                                         std::string& error);

}  // namespace stig::search
