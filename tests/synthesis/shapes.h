// SPDX-License-Identifier: MIT
// Targets for tests and benchmarks: boxes, plates, pyramids, and what is read from a drawing.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "support/uses.h"
#include "synthesis/frame.h"

namespace stig {

/// The cells for which `keep` is true, of a box with its lowest corner at the origin.
template <class Keep>
Target carved(Offset size, const Keep& keep) {
  Target target;
  for (std::int32_t x = 0; x < size.x; ++x) {
    for (std::int32_t y = 0; y < size.y; ++y) {
      for (std::int32_t z = 0; z < size.z; ++z) {
        if (keep(Cell{x, y, z})) target.cells.push_back({x, y, z});
      }
    }
  }
  target.colours.assign(target.cells.size(), StateSet::anything());
  return target;
}

inline Target box(Offset size) {
  return carved(size, [](Cell) { return true; });
}

/// Side 2·radius + 1, standing on z = 0; level z has the cells within radius - z.
inline Target pyramid(int radius) {
  return carved({2 * radius + 1, 2 * radius + 1, radius + 1}, [=](Cell c) {
    return std::max(std::abs(c.x - radius), std::abs(c.y - radius)) <= radius - c.z;
  });
}

inline Target hollow_box(int side) {
  return carved({side, side, side}, [=](Cell c) {
    return c.x % (side - 1) == 0 || c.y % (side - 1) == 0 || c.z % (side - 1) == 0;
  });
}

/// A drawing as in a .txt file; digits are colours when they are kept.
Target drawn(std::string_view text, ColourUse use, Lattice lattice = Lattice::cubic);

/// Three columns of falling height, and the cross of four of them about the tall one.
Target staircase(ColourUse use);
Target stepped_cross(ColourUse use);

}  // namespace stig
