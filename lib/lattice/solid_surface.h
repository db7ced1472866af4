// SPDX-License-Identifier: MIT
// The surface of a structure as printers of solids take it: closed, with two triangles at every
// edge and one fan of triangles about every corner.
//
// Bricks that meet at an edge or a corner alone share a line or a point that has no inside:
// four faces at one edge are no manifold, and slicers guess. There each brick, or each group of
// bricks that meet by their faces, keeps a corner of its own, drawn into it by kGap, so that a gap
// of about twice that is between them. Elsewhere nothing moves.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lattice/mesh.h"

namespace stig::lattice {

constexpr double kGap = 1.0 / 128;  ///< cell widths

struct SolidSurface {
  struct Triangle {
    std::array<std::uint32_t, 3> corner{};  ///< index into points; counter-clockwise from outside
  };
  std::vector<Point> points;  ///< in cell widths
  std::vector<Triangle> triangles;
};

/// The mesh must be unmerged. In the mesh's order.
SolidSurface solid_surface(const Mesh& mesh);

}  // namespace stig::lattice
