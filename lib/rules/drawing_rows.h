// SPDX-License-Identifier: MIT
// A drawing as rows of symbols that know where they stand. Used by the readers of drawings.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stig::rules {

struct DrawnSymbol {
  std::string text;
  std::size_t begin = 0;  ///< in the scalar's text
};

/// A line that is not blank.
struct DrawnRow {
  std::vector<DrawnSymbol> tokens;
  std::size_t begin = 0, end = 0;
};

std::vector<DrawnRow> split_rows(std::string_view text);

}  // namespace stig::rules
