// SPDX-License-Identifier: MIT
// A structure seen by a viewer far away: which faces show, in which order to paint
// them, and where they fall on the page.
//
// The usual viewer stands 30° above the ground. Cubic: 52° from the x axis towards -y, not
// the 45° of an isometric view, in which a step down towards the viewer cannot be told
// from a level. Hexagonal: 30° from the q axis, before an edge of the prisms.
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

/// Where the viewer is: unit vectors, square to each other, and how cells are ordered.
struct LatticeCamera {
  Point right, up;  ///< of the page
  Point towards;    ///< the viewer
  Point depth;      ///< the sum of these times the cell's coordinates grows towards the viewer
};

const LatticeCamera& usual_camera(Lattice lattice);
/// `azimuth` is the viewer's from the x axis, counter-clockwise from above, `elevation` that above
/// the ground, -π/2 to π/2; rad.
LatticeCamera camera_at(Lattice lattice, double azimuth, double elevation);

/// Orthographic projection of a point in cell widths.
PagePoint project(const LatticeCamera& camera, Point point);
/// As the usual viewer sees it.
PagePoint project(Lattice lattice, Point point);

struct ShownFace {
  Cell at;
  Colour colour = 0;
  std::uint8_t face = 0;  ///< index into cell_faces
  bool ghost = false;     ///< of a brick that is still to come
};

/// Quarter turns (cubic) or sixth turns (hexagonal), counter-clockwise from above,
/// that bring the corner "+x-y", "+x+y", "-x+y" or "-x-y" to the viewer; nothing for
/// another name.
std::optional<int> turns_for_view(std::string_view corner, Lattice lattice);

/// The structure after so many turns about the vertical through cell (0, 0, 0).
Structure turned(const Structure& structure, int turns);

/// Faces towards the viewer that border on empty cells, from the farthest to the
/// nearest: painted in this order, near ones cover far ones. Bricks of `to_come` whose cells the
/// structure has not filled are ghosts, of which those faces are shown that border on no brick of
/// either; the structure's own faces show through them.
std::vector<ShownFace> shown_faces(const Structure& structure, const LatticeCamera& camera,
                                   const Structure* to_come = nullptr);
/// As the usual viewer sees them.
std::vector<ShownFace> shown_faces(const Structure& structure);

}  // namespace stig::lattice
