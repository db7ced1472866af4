// SPDX-License-Identifier: MIT
// An orthographic view from a fixed camera; other corners are shown by turning the
// structure. Faces are ordered by an integer depth that is monotone along every line of
// sight, so the painter's algorithm needs no splitting and no tests of geometry.
#include "lattice/view.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace stig::lattice {

namespace {

// Unit vectors of the page, and the faces that look at the viewer.
struct Camera {
  Point right, up;
  std::array<std::uint8_t, 3> faces;  // top, left, right: indices into cell_faces
};

constexpr double kSin52 = 0.78801075360672195669, kCos52 = 0.61566147532565827;
constexpr double kCos30 = 0.86602540378443864676;

constexpr Camera kCubic = {{kSin52, kCos52, 0}, {-kCos52 / 2, kSin52 / 2, kCos30}, {4, 3, 0}};
constexpr Camera kHexagonal = {{0.5, kCos30, 0}, {-kCos30 / 2, 0.25, kCos30}, {6, 5, 0}};

const Camera& camera(Lattice lattice) { return lattice == Lattice::cubic ? kCubic : kHexagonal; }

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// A brick can hide part of another only if its depth is greater. If a line of sight
// meets both, their offset is a piece of that line and something less than a cell, so
// none of the terms below, whole numbers that grow along the line, can be negative.
int depth(Lattice lattice, Cell c) {
  return lattice == Lattice::cubic ? c.x - c.y + c.z : c.x + c.z;
}

}  // namespace

PagePoint project(Lattice lattice, Point point) {
  // The page's y points down.
  return {dot(point, camera(lattice).right), -dot(point, camera(lattice).up)};
}

std::optional<int> turns_for_view(std::string_view corner, Lattice lattice) {
  constexpr std::array<std::string_view, 4> kCorners = {"+x-y", "-x-y", "-x+y", "+x+y"};
  // Six turns of 60° have no quarter among them; the nearest ones stand for the corners.
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
  const auto& faces = cell_faces(lattice);
  std::vector<PlacedBrick> bricks = structure.bricks();
  // Stable, so bricks of one depth keep the order of cells and pictures are reproducible.
  std::stable_sort(bricks.begin(), bricks.end(), [&](const PlacedBrick& a, const PlacedBrick& b) {
    return depth(lattice, a.at) < depth(lattice, b.at);
  });
  for (const PlacedBrick& brick : bricks) {
    for (const Side side : {Side::top, Side::left, Side::right}) {
      const std::uint8_t face = camera(lattice).faces[static_cast<std::size_t>(side)];
      if (structure.at(brick.at + faces[face].towards) != kEmpty) continue;
      shown.push_back({brick.at, brick.brick, face, side});
    }
  }
  return shown;
}

}  // namespace stig::lattice
