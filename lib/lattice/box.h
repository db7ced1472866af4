// SPDX-License-Identifier: MIT
// The region of the lattice in which bricks may be placed.
//
// Nothing is ever placed outside. Cells outside a solid box look empty to rules
// (below z = 0 of a set with `floor: true` they look like floor); a periodic box
// wraps in x and y, and in z as well unless there is a floor.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/uses.h"
#include "rules/rule_set.h"

namespace stig::lattice {

struct Box {
  Cell low;
  Offset size;            ///< each >= 1
  bool periodic = false;  ///< sides wrap; with `floor` the vertical does not
  bool floor = false;     ///< wraps x and y alone when periodic

  bool contains(Cell c) const {
    return c.x >= low.x && c.x - low.x < size.x && c.y >= low.y && c.y - low.y < size.y &&
           c.z >= low.z && c.z - low.z < size.z;
  }
  std::int64_t cells() const {
    return std::int64_t{size.x} * std::int64_t{size.y} * std::int64_t{size.z};
  }
  /// The cell inside that a periodic box shows at c; c itself when not periodic.
  Cell wrap(Cell c) const;
};

/// Lays a box of the given size around a start: at `origin` if given, otherwise
/// with the start's bounding box in the middle (rounded down) of x and y, and of z
/// too, unless there is a floor: then it stands on z = 0.
Box lay_box(const BoxSpec& spec, const std::vector<PlacedBrick>& start, bool floor);

}  // namespace stig::lattice
