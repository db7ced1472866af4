// SPDX-License-Identifier: MIT
// The visible surface as polygons with integer corners. Faces are found cell by cell
// against the empty neighbours; for merging, those of one direction are sorted by plane,
// row and column, joined to runs along a row, and equal runs of neighbouring rows are
// stacked to rectangles. That greedy scheme is linear after sorting and close to the fewest
// rectangles on blocky shapes.
#include "lattice/mesh.h"

#include <algorithm>
#include <cassert>

namespace stig::lattice {

namespace {

constexpr double kSqrt3 = 1.73205080756887729353;

// The four corners of a cube's face on the side `sign` of `axis`, in half cells
// from the foot, counter-clockwise from outside.
CellFace cube_face(int axis, int sign) {
  CellFace face;
  std::array<int, 3> towards{};
  towards[static_cast<std::size_t>(axis)] = sign;
  face.towards = {towards[0], towards[1], towards[2]};
  face.normal = {static_cast<double>(towards[0]), static_cast<double>(towards[1]),
                 static_cast<double>(towards[2])};
  constexpr std::array<std::array<int, 2>, 4> kRound = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    // Reversing the corners for the far side keeps them counter-clockwise as seen from
    // outside.
    const auto& [u, v] = kRound[sign > 0 ? i : 3 - i];
    std::array<int, 3> at{};
    at[static_cast<std::size_t>(axis)] = sign;
    at[static_cast<std::size_t>((axis + 1) % 3)] = u;
    at[static_cast<std::size_t>((axis + 2) % 3)] = v;
    face.corner[i] = {at[0], at[1], at[2] + 1};
  }
  return face;
}

std::vector<CellFace> cube_faces() {
  std::vector<CellFace> faces;
  for (int axis = 0; axis < 3; ++axis) {
    faces.push_back(cube_face(axis, 1));
    faces.push_back(cube_face(axis, -1));
  }
  return faces;
}

// Corner k of a prism stands at 30° + 60°·k, between the sides k and k + 1.
constexpr std::array<std::array<int, 2>, 6> kHexagon = {
    {{1, 1}, {0, 2}, {-1, 1}, {-1, -1}, {0, -2}, {1, -1}}};

Corner hexagon_corner(std::size_t k, int z) { return {kHexagon[k % 6][0], kHexagon[k % 6][1], z}; }

std::vector<CellFace> prism_faces() {
  // The order of the sides is that of rising angle, which kHexagon's corners presuppose.
  constexpr std::array<Offset, 6> kSides = {
      {{1, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, -1, 0}}};
  std::vector<CellFace> faces;
  for (std::size_t k = 0; k < 6; ++k) {
    CellFace side;
    side.towards = kSides[k];
    side.normal = embed(Lattice::hexagonal, Cell{} + kSides[k]);
    side.corner = {hexagon_corner(k + 5, 0), hexagon_corner(k, 0), hexagon_corner(k, 2),
                   hexagon_corner(k + 5, 2)};
    faces.push_back(side);
  }
  CellFace top{{0, 0, 1}, {0, 0, 1}, 6, {}};
  CellFace bottom{{0, 0, -1}, {0, 0, -1}, 6, {}};
  for (std::size_t k = 0; k < 6; ++k) {
    top.corner[k] = hexagon_corner(k, 2);
    bottom.corner[k] = hexagon_corner(5 - k, 0);
  }
  faces.push_back(top);
  faces.push_back(bottom);
  return faces;
}

// A face on its way into the mesh: its plane, and its place in the plane as row and
// column, along which rectangles grow.
struct FlatFace {
  std::int32_t plane, row, column;
  Colour colour;
  Cell at;
};

// Rows and columns of a face's plane, in cells. Cubic: the two other axes in the
// order in which cube_face turns. Prism: sides grow along the vertical alone; each
// column (q, r) is a plane of its own, told apart by plane and row.
FlatFace flatten(Lattice lattice, std::size_t face, const PlacedBrick& brick) {
  const Cell c = brick.at;
  if (lattice == Lattice::hexagonal) return {c.x, c.y, c.z, brick.brick, c};
  const std::array<std::int32_t, 3> at = {c.x, c.y, c.z};
  const std::size_t axis = face / 2;
  return {at[axis], at[(axis + 2) % 3], at[(axis + 1) % 3], brick.brick, c};
}

struct Rectangle {
  FlatFace first;
  std::int32_t columns = 1, rows = 1;
};

std::vector<Rectangle> runs_along_rows(const std::vector<FlatFace>& faces) {
  std::vector<Rectangle> runs;
  // Faces come sorted, so a run can only be continued by the next face.
  for (const FlatFace& f : faces) {
    if (!runs.empty()) {
      Rectangle& run = runs.back();
      if (run.first.plane == f.plane && run.first.row == f.row && run.first.colour == f.colour &&
          run.first.column + run.columns == f.column) {
        ++run.columns;
        continue;
      }
    }
    runs.push_back({f});
  }
  return runs;
}

// Stacks equal runs of neighbouring rows. `runs` come by plane, row, column, so each
// row is joined to the rectangles that ended in the row before by walking both.
std::vector<Rectangle> stacked(const std::vector<Rectangle>& runs) {
  std::vector<Rectangle> out;
  std::vector<std::size_t> before, current;  // rectangles that reach the last and this row
  std::size_t walk = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const FlatFace& f = runs[i].first;
    const bool new_plane = i == 0 || f.plane != runs[i - 1].first.plane;
    if (new_plane || f.row != runs[i - 1].first.row) {
      const bool adjacent = !new_plane && f.row == runs[i - 1].first.row + 1;
      before = adjacent ? std::move(current) : std::vector<std::size_t>{};
      current.clear();
      walk = 0;
    }
    while (walk < before.size() && out[before[walk]].first.column < f.column) ++walk;
    const bool joins = walk < before.size() && out[before[walk]].first.column == f.column &&
                       out[before[walk]].columns == runs[i].columns &&
                       out[before[walk]].first.colour == f.colour;
    if (joins) {
      ++out[before[walk]].rows;
      current.push_back(before[walk]);
    } else {
      current.push_back(out.size());
      out.push_back(runs[i]);
    }
  }
  return out;
}

// Corners of a merged face: those beyond the middle of the face move out with it.
Polygon grown(Lattice lattice, std::size_t face, const Rectangle& rectangle) {
  assert(face < cell_faces(lattice).size());
  const CellFace& shape = cell_faces(lattice)[face];
  Polygon polygon = face_polygon(lattice, face, {rectangle.first.at, rectangle.first.colour});
  const Corner foot = foot_of(lattice, rectangle.first.at);
  for (std::size_t i = 0; i < polygon.corners; ++i) {
    std::array<std::int32_t, 3> at = {shape.corner[i].x, shape.corner[i].y, shape.corner[i].z - 1};
    const auto grow = [&](std::size_t axis, std::int32_t cells) {
      // Only the corners on the positive side move: the face keeps its foot and grows along
      // its axes.
      if (at[axis] > 0) at[axis] += 2 * (cells - 1);
    };
    if (lattice == Lattice::hexagonal) {
      grow(2, rectangle.columns);
    } else {
      grow((face / 2 + 1) % 3, rectangle.columns);
      grow((face / 2 + 2) % 3, rectangle.rows);
    }
    polygon.corner[i] = foot + Corner{at[0], at[1], at[2] + 1};
  }
  return polygon;
}

}  // namespace

const std::vector<CellFace>& cell_faces(Lattice lattice) {
  // Built once; the tables are constant and shared by all threads.
  static const std::vector<CellFace> cube = cube_faces();
  static const std::vector<CellFace> prism = prism_faces();
  return lattice == Lattice::cubic ? cube : prism;
}

Corner foot_of(Lattice lattice, Cell cell) {
  if (lattice == Lattice::cubic) return {2 * cell.x, 2 * cell.y, 2 * cell.z};
  return {2 * cell.x + cell.y, 3 * cell.y, 2 * cell.z};
}

/// Hexagonal corners are stored in units of 1/2 and 1/(2 sqrt 3), in which all of them are
/// integers.
Point position(Lattice lattice, Corner corner) {
  const double y = lattice == Lattice::cubic ? corner.y / 2.0 : corner.y / (2 * kSqrt3);
  return {corner.x / 2.0, y, corner.z / 2.0};
}

Polygon face_polygon(Lattice lattice, std::size_t face, const PlacedBrick& brick) {
  assert(face < cell_faces(lattice).size());
  const CellFace& shape = cell_faces(lattice)[face];
  Polygon polygon{
      brick.brick, static_cast<std::uint8_t>(face), static_cast<std::uint8_t>(shape.corners), {}};
  const Corner foot = foot_of(lattice, brick.at);
  for (std::size_t i = 0; i < polygon.corners; ++i) polygon.corner[i] = foot + shape.corner[i];
  return polygon;
}

std::size_t Mesh::triangles() const {
  std::size_t count = 0;
  for (const Polygon& polygon : polygons) count += polygon.corners - 2U;
  return count;
}

Mesh surface(const Structure& structure, Merging merging) {
  Mesh mesh{structure.lattice(), {}};
  const std::vector<PlacedBrick> bricks = structure.bricks();
  const std::vector<CellFace>& faces = cell_faces(mesh.lattice);
  std::vector<FlatFace> flat;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    flat.clear();
    for (const PlacedBrick& brick : bricks) {
      if (structure.at(brick.at + faces[face].towards) != kEmpty) continue;
      flat.push_back(flatten(mesh.lattice, face, brick));
    }
    std::sort(flat.begin(), flat.end(), [](const FlatFace& a, const FlatFace& b) {
      return std::tie(a.plane, a.row, a.column) < std::tie(b.plane, b.row, b.column);
    });
    const bool grows = merging == Merging::faces && faces[face].corners == 4;
    if (!grows) {
      for (const FlatFace& f : flat) mesh.polygons.push_back(grown(mesh.lattice, face, {f}));
    } else {
      std::vector<Rectangle> rectangles = runs_along_rows(flat);
      if (mesh.lattice == Lattice::cubic) rectangles = stacked(rectangles);
      for (const Rectangle& r : rectangles) mesh.polygons.push_back(grown(mesh.lattice, face, r));
    }
  }
  return mesh;
}

}  // namespace stig::lattice
