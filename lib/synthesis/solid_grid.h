// SPDX-License-Identifier: MIT
// A target in a dense box, in which growth is followed step by step. A place is an index into
// the box; the box has room for all that a site beside the target sees.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "synthesis/target.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct SolidGrid {
  Lattice lattice = Lattice::cubic;
  Cell low;                          ///< the box's lowest cell
  Offset size;                       ///< cells along x, y, z
  std::vector<std::int32_t> step;    ///< by neighbour: from a place to that neighbour's
  std::vector<std::uint8_t> solid;   ///< by place: is it of the target?
  std::vector<std::int32_t> cells;   ///< places of the target's cells, in their order
  std::vector<std::int32_t> beside;  ///< empty places beside the target, none below a floor

  const Neighbourhood& neighbours() const { return neighbourhood(lattice); }
  std::int32_t place_of(Cell cell) const {
    return ((cell.z - low.z) * size.y + cell.y - low.y) * size.x + cell.x - low.x;
  }
  std::int32_t height(std::int32_t place) const { return low.z + place / (size.x * size.y); }
  bool is_solid(std::int32_t place) const { return solid[static_cast<std::size_t>(place)] != 0; }
  /// The neighbours of a place that are of the target, a bit each.
  std::uint32_t solid_beside(std::int32_t place) const;
};

/// Nothing when the box is very large.
std::optional<SolidGrid> make_solid_grid(const Target& target, bool floor);

}  // namespace stig::synthesis
