// SPDX-License-Identifier: MIT
// A structure seen by a viewer far away: which faces show, in which order to paint
// them, and where they fall on the page.
//
// The viewer stands 30° above the ground. Cubic: 52° from the x axis towards -y, not
// the 45° of an isometric view, in which a step down towards the viewer cannot be told
// from a level. Hexagonal: 30° from the q axis, before an edge of the prisms. Other
// views turn the structure, not the viewer.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lattice/mesh.h"
#include "lattice/uses.h"

namespace stig::lattice {

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

/// Faces towards the viewer that border on empty cells, from the farthest to the
/// nearest: painted in this order, near ones cover far ones.
std::vector<ShownFace> shown_faces(const Structure& structure);

}  // namespace stig::lattice
