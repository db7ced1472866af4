// SPDX-License-Identifier: MIT
// A structure seen by a viewer far away: which faces show, in which order to paint
// them, and where they fall on the page.
//
// The viewer looks at the corner of the cells. Cubic: isometric, from +x -y and
// above, along (1, -1, 1). Hexagonal: from +q and 30° above, along (2, -1, 1). Both
// lines of sight run through cell centres, so a brick on the line hides the whole
// of the brick behind it. Other views turn the structure, not the viewer.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lattice/mesh.h"

namespace stig {

/// On the page, in cell widths: x to the right, y down.
struct PagePoint {
  double x = 0, y = 0;
};

/// Orthographic projection of a point in cell widths.
PagePoint project(Lattice lattice, Point point);

enum class Side : std::uint8_t { top, left, right };

struct ShownFace {
  Cell at;
  Colour colour = 0;
  std::uint8_t face = 0;  ///< index into cell_faces
  Side side = Side::top;
};

/// Quarter turns (cubic) or sixth turns (hexagonal), counter-clockwise from above,
/// that bring the corner "+x-y", "+x+y", "-x+y" or "-x-y" to the viewer; nothing for
/// another name.
std::optional<int> turns_for_view(std::string_view corner, Lattice lattice);

/// The structure after so many turns about the vertical through cell (0, 0, 0).
Structure turned(const Structure& structure, int turns);

/// Faces towards the viewer that border on empty cells, of bricks that are not
/// wholly hidden, from the farthest to the nearest.
std::vector<ShownFace> shown_faces(const Structure& structure);

}  // namespace stig
