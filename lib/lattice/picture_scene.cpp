// SPDX-License-Identifier: MIT
// Gathers what will be drawn of a structure and the rectangle that it takes up on the page.
// Limits leave out shadows and tiles of very large scenes, where they would not be seen and
// would cost more than the bricks.
#include "lattice/picture_scene.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

constexpr std::size_t kMostShadows = 20000;      // bricks; beyond, shadows are left out
constexpr std::size_t kMostTiledColumns = 5000;  // hexagonal: beyond, so is the ground
constexpr int kFarthestShadow = 6;               // cells that the ground grows for shadows

// The cells under the bricks and their shadows, and two more all round.
std::vector<Cell> tiles_under(const std::vector<PlacedBrick>& bricks) {
  std::vector<Cell> tiles;
  for (const PlacedBrick& brick : bricks) {
    // Shadows of high bricks fall far; the ground grows with them up to a limit.
    const int shadow = std::min(brick.at.z * 3 / 10, kFarthestShadow);
    for (const int r : {0, shadow}) tiles.push_back({brick.at.x, brick.at.y + r, 0});
  }
  std::sort(tiles.begin(), tiles.end());
  tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
  if (tiles.size() > kMostTiledColumns) return {};
  std::vector<Cell> wide;
  for (const Cell& tile : tiles) {
    for (int q = -2; q <= 2; ++q) {
      for (int r = std::max(-2, -q - 2); r <= std::min(2, -q + 2); ++r) {
        wide.push_back(tile + Offset{q, r, 0});
      }
    }
  }
  std::sort(wide.begin(), wide.end());
  wide.erase(std::unique(wide.begin(), wide.end()), wide.end());
  return wide;
}

void add_outline(PictureFrame& frame, const Outline& outline) {
  for (std::size_t i = 0; i < outline.count; ++i) frame.add(outline.at[i]);
}

/// The frame contains what may be painted and nothing else, so pages have no empty margins
/// but the intended ones.
void find_frame(PictureScene& scene) {
  for (const ShownFace& face : scene.faces) {
    add_outline(scene.frame, outline_of(scene, face.at, face.face));
  }
  if (scene.faces.empty()) add_outline(scene.frame, outline_of(scene, {}, 0));
  if (!scene.floor) return;
  for (const Cell& tile : scene.tiles) {
    add_outline(scene.frame, outline_of(scene, tile, bottom_face(scene.lattice)));
  }
  if (scene.lattice == Lattice::cubic) {
    for (const Corner& corner : ground_corners(scene.box)) {
      scene.frame.add(on_page(scene, corner));
    }
  }
}

/// Both bounds are inclusive; the union of two boxes is their common bounding box.
void extend(CellBounds& box, const CellBounds& other) {
  box.low = {std::min(box.low.x, other.low.x), std::min(box.low.y, other.low.y),
             std::min(box.low.z, other.low.z)};
  box.high = {std::max(box.high.x, other.high.x), std::max(box.high.y, other.high.y),
              std::max(box.high.z, other.high.z)};
}

}  // namespace

Outline outline_of(const PictureScene& scene, Cell cell, std::size_t face) {
  assert(face < cell_faces(scene.lattice).size());
  const CellFace& shape = cell_faces(scene.lattice)[face];
  const Corner foot = foot_of(scene.lattice, cell);
  Outline outline;
  outline.count = static_cast<std::size_t>(shape.corners);
  for (std::size_t i = 0; i < outline.count; ++i) {
    outline.at[i] = on_page(scene, foot + shape.corner[i]);
  }
  return outline;
}

/// The faces' order is that of cell_faces: -z is the last of six, the bottom the last of
/// eight.
std::size_t bottom_face(Lattice lattice) { return lattice == Lattice::cubic ? 5 : 7; }

PagePoint on_page(const PictureScene& scene, Corner corner) {
  return project(scene.camera, position(scene.lattice, corner));
}

std::array<Corner, 4> ground_corners(const CellBounds& box) {
  const int height = std::max(box.high.z + 1, 0);
  const auto reach = [height](double slope) {
    return std::min(static_cast<int>(std::ceil(slope * height)), kFarthestShadow);
  };
  const Corner low = foot_of(Lattice::cubic, {box.low.x - 1, box.low.y - 1, 0});
  const Corner high = foot_of(Lattice::cubic, {box.high.x + std::max(1, reach(0.12)),
                                               box.high.y + std::max(1, reach(0.35)), 0});
  return {{{low.x - 1, low.y - 1, 0},
           {high.x + 1, low.y - 1, 0},
           {high.x + 1, high.y + 1, 0},
           {low.x - 1, high.y + 1, 0}}};
}

void PictureFrame::add(PagePoint p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

PictureScene make_scene(const Structure& structure, bool floor, const LatticeCamera& camera,
                        const Structure* to_come) {
  PictureScene scene;
  scene.lattice = structure.lattice();
  scene.camera = camera;
  // Seen edge-on or from below, the ground would be a line or hide what stands on it.
  scene.floor = floor && camera.towards.z > 1e-9;
  scene.faces = shown_faces(structure, camera, to_come);
  scene.box = structure.bounds().value_or(CellBounds{});
  if (scene.floor) {
    const std::vector<PlacedBrick> bricks = structure.bricks();
    if (bricks.size() <= kMostShadows) {
      for (const PlacedBrick& brick : bricks) scene.shadowing.push_back(brick.at);
    }
    if (scene.lattice == Lattice::hexagonal) scene.tiles = tiles_under(bricks);
  }
  find_frame(scene);
  return scene;
}

void share_frame(std::vector<PictureScene>& scenes) {
  // A common frame and ground keep several panels comparable: equal cells have equal sizes
  // and places.
  assert(!scenes.empty());
  PictureScene all = scenes.front();
  for (const PictureScene& scene : scenes) {
    extend(all.box, scene.box);
    all.tiles.insert(all.tiles.end(), scene.tiles.begin(), scene.tiles.end());
    all.frame.add(scene.frame.low);
    all.frame.add(scene.frame.high);
  }
  std::sort(all.tiles.begin(), all.tiles.end());
  all.tiles.erase(std::unique(all.tiles.begin(), all.tiles.end()), all.tiles.end());
  find_frame(all);
  for (PictureScene& scene : scenes) {
    scene.box = all.box;
    scene.tiles = all.tiles;
    scene.frame = all.frame;
  }
}

}  // namespace stig::lattice
