// SPDX-License-Identifier: MIT
#include "rules/drawing_rows.h"

#include <algorithm>

namespace stig::rules {

/// Any white space separates symbols, so drawings can be lined up as their author likes;
/// blank lines are no rows. Offsets are kept for exact carets.
std::vector<DrawnRow> split_rows(std::string_view text) {
  static constexpr std::string_view kSpace = " \t\r\n";
  std::vector<DrawnRow> rows;
  bool new_row = true;
  for (std::size_t i = 0; i < text.size();) {
    if (kSpace.find(text[i]) != kSpace.npos) {
      new_row = new_row || text[i] == '\n';
      ++i;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(kSpace, i), text.size());
    if (new_row) rows.push_back({{}, i, end});
    new_row = false;
    rows.back().tokens.push_back({std::string(text.substr(i, end - i)), i});
    rows.back().end = end;
    i = end;
  }
  return rows;
}

}  // namespace stig::rules
