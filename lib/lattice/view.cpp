// SPDX-License-Identifier: MIT
#include "lattice/view.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace stig {

namespace {

// Unit vectors of the page, and the cells along the line of sight.
struct Camera {
  Point right, up;
  Offset sight;
  std::array<std::uint8_t, 3> faces;  // top, left, right: indices into cell_faces
};

constexpr double kRoot2 = 0.70710678118654752440;   // √(1/2)
constexpr double kRoot6 = 0.40824829046386301637;   // √(1/6)
constexpr double kRoot23 = 0.81649658092772603273;  // √(2/3)
constexpr double kCos30 = 0.86602540378443864676;

constexpr Camera kIsometric = {
    {kRoot2, kRoot2, 0}, {-kRoot6, kRoot6, kRoot23}, {1, -1, 1}, {4, 3, 0}};
constexpr Camera kHexagonal = {
    {0.5, kCos30, 0}, {-kCos30 / 2, 0.25, kCos30}, {2, -1, 1}, {6, 5, 0}};

const Camera& camera(Lattice lattice) {
  return lattice == Lattice::cubic ? kIsometric : kHexagonal;
}

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// A brick can hide part of another only if its depth is greater: if a sight line
// meets both, their offset differs from a multiple of the line by less than a cell,
// and none of its parts below can then be negative.
int depth(Lattice lattice, Cell c) {
  return lattice == Lattice::cubic ? c.x - c.y + c.z : c.x + c.z;
}

bool hidden(const Structure& structure, const Bounds& bounds, Cell cell) {
  constexpr int kFarthest = 64;  // beyond, a brick is painted in vain
  const Offset sight = camera(structure.lattice()).sight;
  for (int i = 0; i < kFarthest; ++i) {
    cell = cell + sight;
    if (cell.z > bounds.high.z || cell.x > bounds.high.x || cell.y < bounds.low.y) return false;
    if (structure.at(cell) != kEmpty) return true;
  }
  return false;
}

}  // namespace

PagePoint project(Lattice lattice, Point point) {
  return {dot(point, camera(lattice).right), -dot(point, camera(lattice).up)};
}

std::optional<int> turns_for_view(std::string_view corner, Lattice lattice) {
  constexpr std::array<std::string_view, 4> kCorners = {"+x-y", "-x-y", "-x+y", "+x+y"};
  constexpr std::array<int, 4> kSixths = {0, 2, 3, 5};
  const auto found = std::find(kCorners.begin(), kCorners.end(), corner);
  if (found == kCorners.end()) return std::nullopt;
  const auto quarters = static_cast<std::size_t>(found - kCorners.begin());
  return lattice == Lattice::cubic ? static_cast<int>(quarters) : kSixths[quarters];
}

Structure turned(const Structure& structure, int turns) {
  const auto group = orientations(structure.lattice(), Symmetry::rotations, false);
  const int count = static_cast<int>(group.size());
  return transformed(structure, group[static_cast<std::size_t>((turns % count + count) % count)]);
}

std::vector<ShownFace> shown_faces(const Structure& structure) {
  std::vector<ShownFace> shown;
  if (structure.empty()) return shown;
  const Lattice lattice = structure.lattice();
  const Bounds bounds = *structure.bounds();
  const auto& faces = cell_faces(lattice);
  std::vector<PlacedBrick> bricks = structure.bricks();
  std::stable_sort(bricks.begin(), bricks.end(), [&](const PlacedBrick& a, const PlacedBrick& b) {
    return depth(lattice, a.at) < depth(lattice, b.at);
  });
  for (const PlacedBrick& brick : bricks) {
    if (hidden(structure, bounds, brick.at)) continue;
    for (const Side side : {Side::top, Side::left, Side::right}) {
      const std::uint8_t face = camera(lattice).faces[static_cast<std::size_t>(side)];
      if (structure.at(brick.at + faces[face].towards) != kEmpty) continue;
      shown.push_back({brick.at, brick.brick, face, side});
    }
  }
  return shown;
}

}  // namespace stig
