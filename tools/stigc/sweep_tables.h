// SPDX-License-Identifier: MIT
// Records of a study as files: JSON Lines, and CSV made of them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app.h"
#include "uses.h"

namespace stig::cli {

/// Calls with every record's line in the order of items; false where that cannot be read.
using EachRecord = std::function<bool(const std::function<bool(std::string_view line)>& each)>;

/// An exit code: kUsage where a name ends neither in .jsonl nor in .csv, or is no name for a file.
int check_tables(const std::vector<std::string>& paths, const std::vector<std::string>& others,
                 const App& app);

struct TablesWritten {
  int code = 0;
  std::uint64_t records = 0;
  std::uint64_t hash = 0;  ///< of all records, in their order
};
/// Writes every table, and says so.
TablesWritten write_tables(const std::vector<std::string>& paths, const EachRecord& records,
                           const App& app);

/// What a study came to, for people or as JSON.
std::string study_summary(const TablesWritten& written, std::uint64_t items, bool json);

}  // namespace stig::cli
