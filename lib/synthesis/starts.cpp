// SPDX-License-Identifier: MIT
// Likely starts: the lowest corner, from which all growth is one-sided, and the middle of
// the lowest level, which halves the runs that have to count. Under a symmetry the start
// has to lie on the axis, or around it where the axis passes between cells.
#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>

#include "synthesis/synthesise.h"

namespace stig::synthesis {

std::vector<std::vector<Cell>> likely_starts(const Target& target, Symmetry symmetry, bool) {
  assert(!target.cells.empty());
  Cell low = target.cells.front(), high = low;
  for (const Cell c : target.cells) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  std::vector<std::vector<Cell>> starts;
  if (symmetry != Symmetry::none) {
    // The cells on the axis, or nearest to it, level by level from the lowest.
    for (std::int32_t z = low.z; z <= high.z && starts.empty(); ++z) {
      std::vector<Cell> middle;
      // One cell where the extent is odd, two where it is even.
      for (std::int32_t x = (low.x + high.x) >> 1; x <= (low.x + high.x + 1) >> 1; ++x) {
        for (std::int32_t y = (low.y + high.y) >> 1; y <= (low.y + high.y + 1) >> 1; ++y) {
          if (index_in(target.cells, {x, y, z}) >= 0) middle.push_back({x, y, z});
        }
      }
      if (!middle.empty()) starts.push_back(middle);
    }
    if (starts.empty()) starts.push_back({target.cells.front()});
    return starts;
  }
  const auto by = [&](const auto& key) {
    return *std::min_element(target.cells.begin(), target.cells.end(),
                             [&](Cell a, Cell b) { return key(a) < key(b); });
  };
  const auto add = [&](Cell c) {
    const std::vector<Cell> start{c};
    if (std::find(starts.begin(), starts.end(), start) == starts.end()) starts.push_back(start);
  };
  add(by([](Cell c) { return std::array{c.z, c.y, c.x}; }));
  const auto from_middle = [&](Cell c) {
    return std::abs(2 * c.x - low.x - high.x) + std::abs(2 * c.y - low.y - high.y);
  };
  add(by([&](Cell c) { return std::array{c.z, from_middle(c), c.y, c.x}; }));
  return starts;
}

}  // namespace stig::synthesis
