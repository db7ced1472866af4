// SPDX-License-Identifier: MIT
// An orthographic view. Cells are ordered by a depth that is monotone along every line of
// sight, so the painter's algorithm needs no splitting and no tests of geometry.
#include "lattice/view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stig::lattice {

namespace {

constexpr double kSin52 = 0.78801075360672195669, kCos52 = 0.61566147532565827;
constexpr double kCos30 = 0.86602540378443864676;
constexpr double kEdgeOn = 1e-9;  // a face that looks less towards the viewer is a line

// If a line of sight meets two bricks, their offset is a piece of that line and something less
// than a cell, so that none of the terms of these depths, whole numbers that grow along the line,
// can be negative.
constexpr LatticeCamera kCubic = {{kSin52, kCos52, 0},
                                  {-kCos52 / 2, kSin52 / 2, kCos30},
                                  {kCos52 * kCos30, -kSin52* kCos30, 0.5},
                                  {1, -1, 1}};
constexpr LatticeCamera kHexagonal = {
    {0.5, kCos30, 0}, {-kCos30 / 2, 0.25, kCos30}, {kCos30 * kCos30, -kCos30 / 2, 0.5}, {1, 0, 1}};

double dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

double depth(const LatticeCamera& camera, Cell c) {
  return camera.depth.x * c.x + camera.depth.y * c.y + camera.depth.z * c.z;
}

/// Indices into cell_faces, falling.
std::vector<std::uint8_t> faces_towards(const LatticeCamera& camera, Lattice lattice) {
  const auto& faces = cell_faces(lattice);
  std::vector<std::uint8_t> out;
  for (std::size_t i = faces.size(); i-- > 0;) {
    if (dot(faces[i].normal, camera.towards) > kEdgeOn) out.push_back(static_cast<std::uint8_t>(i));
  }
  return out;
}

}  // namespace

const LatticeCamera& usual_camera(Lattice lattice) {
  return lattice == Lattice::cubic ? kCubic : kHexagonal;
}

// Cells are the Voronoi cells of their centres: the step from a cell to the next one on a line of
// sight is along the normal of the face between them, which the line passes from behind. So the
// centres' projections on the line rise from cell to cell (Edelsbrunner, "An acyclicity theorem for
// cell complexes in d dimensions", Combinatorica 10, 1990), and they are the depth.
LatticeCamera camera_at(Lattice lattice, double azimuth, double elevation) {
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const double level = std::cos(elevation), rise = std::sin(elevation);
  const Point towards{level * c, level * s, rise};
  const auto along = [&](Offset axis) { return dot(embed(lattice, Cell{} + axis), towards); };
  return {{-s, c, 0},
          {-rise * c, -rise * s, level},
          towards,
          {along({1, 0, 0}), along({0, 1, 0}), rise}};
}

PagePoint project(const LatticeCamera& camera, Point point) {
  // The page's y points down.
  return {dot(point, camera.right), -dot(point, camera.up)};
}

PagePoint project(Lattice lattice, Point point) { return project(usual_camera(lattice), point); }

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

std::vector<ShownFace> shown_faces(const Structure& structure, const LatticeCamera& camera,
                                   const Structure* to_come) {
  std::vector<ShownFace> shown;
  const Lattice lattice = structure.lattice();
  const auto& faces = cell_faces(lattice);
  const std::vector<std::uint8_t> towards = faces_towards(camera, lattice);
  std::vector<PlacedBrick> bricks = structure.bricks();
  if (to_come != nullptr) {
    for (const PlacedBrick& brick : to_come->bricks()) {
      if (structure.at(brick.at) == kEmpty) bricks.push_back(brick);
    }
  }
  // Stable, so bricks of one depth keep the order of cells and pictures are reproducible.
  std::stable_sort(bricks.begin(), bricks.end(), [&](const PlacedBrick& a, const PlacedBrick& b) {
    return depth(camera, a.at) < depth(camera, b.at);
  });
  for (const PlacedBrick& brick : bricks) {
    const bool ghost = to_come != nullptr && structure.at(brick.at) == kEmpty;
    for (const std::uint8_t face : towards) {
      const Cell next = brick.at + faces[face].towards;
      if (structure.at(next) != kEmpty || (ghost && to_come->at(next) != kEmpty)) continue;
      shown.push_back({brick.at, brick.brick, face, ghost});
    }
  }
  return shown;
}

std::vector<ShownFace> shown_faces(const Structure& structure) {
  return shown_faces(structure, usual_camera(structure.lattice()));
}

}  // namespace stig::lattice
