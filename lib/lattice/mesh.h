// SPDX-License-Identifier: MIT
// The surface of a structure as coloured polygons: the faces that bricks show to
// empty cells, seen from outside counter-clockwise.
//
// Corners are whole numbers, so that neighbours share them exactly:
//   cubic       half cells: the corner (X, Y, Z) lies at (X/2, Y/2, Z/2)
//   hexagonal   at (X/2, Y/(2√3), Z/2); a prism's six corners, round its axis, are
//               (±1, ±1), (0, ±2) from the centre (2q + r, 3r)
//
// The centre of a cell lies above embed() of it; its foot at height z, its top at
// z + 1: the floor is the plane z = 0.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lattice/structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

struct Corner {
  std::int32_t x = 0, y = 0, z = 0;
  auto operator<=>(const Corner&) const = default;
};
constexpr Corner operator+(Corner a, Corner b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// One face of a cell: where it looks and its corners from the cell's foot.
struct CellFace {
  Offset towards;                  ///< the cell that it borders on
  Point normal;                    ///< unit length
  int corners = 4;                 ///< 4, or 6 for the ends of a prism
  std::array<Corner, 6> corner{};  ///< counter-clockwise from outside
};

/// The faces of a cell: cubic +x -x +y -y +z -z; hexagonal the six sides by rising
/// angle from +q, then top and bottom.
const std::vector<CellFace>& cell_faces(Lattice lattice);
/// The whole-number place of a cell's foot: corners are added to it.
Corner foot_of(Lattice lattice, Cell cell);
/// In cell widths.
Point position(Lattice lattice, Corner corner);

struct Polygon {
  Colour colour = 0;
  std::uint8_t face = 0;  ///< index into cell_faces
  std::uint8_t corners = 4;
  std::array<Corner, 6> corner{};
};

/// One face of one brick; `face` is an index into cell_faces.
Polygon face_polygon(Lattice lattice, std::size_t face, const PlacedBrick& brick);

struct Mesh {
  Lattice lattice = Lattice::cubic;
  std::vector<Polygon> polygons;
  /// Number of triangles when each polygon is cut into a fan.
  std::size_t triangles() const;
};

enum class Merging : std::uint8_t {
  none,  ///< one polygon a face: edges match edge to edge, watertight for slicers
  faces  ///< rectangles of one colour merged; far fewer, but with T-junctions
};

/// In a fixed order: by face, plane, row, column.
Mesh surface(const Structure& structure, Merging merging);

}  // namespace stig::lattice
