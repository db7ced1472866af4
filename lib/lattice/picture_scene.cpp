// SPDX-License-Identifier: MIT
#include "lattice/picture_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lattice/rgb.h"

namespace stig {

namespace {

constexpr std::size_t kMostShadows = 20000;      // bricks; beyond, shadows are left out
constexpr std::size_t kMostTiledColumns = 5000;  // hexagonal: beyond, so is the ground
constexpr int kFarthestShadow = 6;               // cells that the ground grows for shadows
constexpr Rgb kGround{0xf4, 0xf6, 0xf8}, kGroundLine{0xdd, 0xe2, 0xe8};
constexpr Rgb kShadow{0x20, 0x2a, 0x38}, kBlack{0, 0, 0}, kWhite{255, 255, 255};

// Light comes from the left, in front and above; where the ground is that a point
// one cell up throws its shadow on.
Point shadow_of(Lattice lattice, double height) {
  if (lattice == Lattice::cubic) return {0.12 * height, 0.35 * height, 0};
  const Point along = embed(lattice, {0, 1, 0});
  return {0.3 * height * along.x, 0.3 * height * along.y, 0};
}

PagePoint on_page(Lattice lattice, Corner corner) {
  return project(lattice, position(lattice, corner));
}

Corner operator+(Corner a, Corner b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

struct Outline {
  std::array<PagePoint, 6> at{};
  std::size_t count = 0;
};

Outline outline_of(Lattice lattice, Cell cell, std::size_t face) {
  const CellFace& shape = cell_faces(lattice)[face];
  const Corner foot = foot_of(lattice, cell);
  Outline outline;
  outline.count = static_cast<std::size_t>(shape.corners);
  for (std::size_t i = 0; i < outline.count; ++i) {
    outline.at[i] = on_page(lattice, foot + shape.corner[i]);
  }
  return outline;
}

std::size_t bottom_face(Lattice lattice) { return lattice == Lattice::cubic ? 5 : 7; }

// ---- making -------------------------------------------------------------------

std::vector<Cell> tiles_under(const std::vector<PlacedBrick>& bricks) {
  std::vector<Cell> tiles;
  for (const PlacedBrick& brick : bricks) {
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

// The cubic ground: the box's floor with a margin, wider where shadows fall.
std::array<Corner, 4> ground_corners(const Bounds& box) {
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

void add_outline(Frame& frame, const Outline& outline) {
  for (std::size_t i = 0; i < outline.count; ++i) frame.add(outline.at[i]);
}

void find_frame(Scene& scene) {
  for (const ShownFace& face : scene.faces) {
    add_outline(scene.frame, outline_of(scene.lattice, face.at, face.face));
  }
  if (scene.faces.empty()) add_outline(scene.frame, outline_of(scene.lattice, {}, 0));
  if (!scene.floor) return;
  for (const Cell& tile : scene.tiles) {
    add_outline(scene.frame, outline_of(scene.lattice, tile, bottom_face(scene.lattice)));
  }
  if (scene.lattice == Lattice::cubic) {
    for (const Corner& corner : ground_corners(scene.box)) {
      scene.frame.add(on_page(scene.lattice, corner));
    }
  }
}

void extend(Bounds& box, const Bounds& other) {
  box.low = {std::min(box.low.x, other.low.x), std::min(box.low.y, other.low.y),
             std::min(box.low.z, other.low.z)};
  box.high = {std::max(box.high.x, other.high.x), std::max(box.high.y, other.high.y),
              std::max(box.high.z, other.high.z)};
}

// ---- painting -----------------------------------------------------------------

PagePoint placed(const Placement& place, PagePoint p) {
  return {place.origin.x + place.scale * p.x, place.origin.y + place.scale * p.y};
}

void paint(Canvas& canvas, const Placement& place, const Outline& outline, Rgb fill, Rgb edge,
           double width) {
  std::array<PagePoint, 6> corners{};
  for (std::size_t i = 0; i < outline.count; ++i) corners[i] = placed(place, outline.at[i]);
  canvas.polygon(corners.data(), outline.count, fill, edge, width);
}

// Cells between two lines of the ground: 1, 2, 5, 10, … so that lines stay apart.
int line_step(double scale) {
  constexpr double kClosest = 7;
  int step = 1;
  for (int i = 0; step * scale < kClosest && step < (1 << 24); ++i)
    step = step * (i % 3 == 1 ? 5 : 4) / 2;
  return step;
}

void paint_cubic_ground(Canvas& canvas, const Scene& scene, const Placement& place) {
  const auto corners = ground_corners(scene.box);
  const auto at = [&](std::int32_t x, std::int32_t y) {
    return placed(place, on_page(scene.lattice, {x, y, 0}));
  };
  const std::array<PagePoint, 4> outline = {
      at(corners[0].x, corners[0].y), at(corners[1].x, corners[1].y),
      at(corners[2].x, corners[2].y), at(corners[3].x, corners[3].y)};
  canvas.polygon(outline.data(), outline.size(), kGround, kGroundLine, 1);
  const int step = 2 * line_step(place.scale);
  const Corner low = corners[0], high = corners[2];
  for (int x = low.x + step; x < high.x; x += step) {
    canvas.line(at(x, low.y), at(x, high.y), kGroundLine, 1);
  }
  for (int y = low.y + step; y < high.y; y += step) {
    canvas.line(at(low.x, y), at(high.x, y), kGroundLine, 1);
  }
}

void paint_ground(Canvas& canvas, const Scene& scene, const Placement& place) {
  if (scene.lattice == Lattice::cubic) return paint_cubic_ground(canvas, scene, place);
  const double width = place.scale < 6 ? 0.5 : 1;
  const Rgb edge = place.scale < 6 ? kGround : kGroundLine;
  for (const Cell& tile : scene.tiles) {
    paint(canvas, place, outline_of(scene.lattice, tile, bottom_face(scene.lattice)), kGround, edge,
          width);
  }
}

double cross(PagePoint o, PagePoint a, PagePoint b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Monotone chain (Andrew 1979).
std::vector<PagePoint> convex_hull(std::vector<PagePoint> points) {
  const auto before = [](PagePoint a, PagePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), before);
  std::vector<PagePoint> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const PagePoint p : points) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Three sheets with the light a little moved: shadows get softer with height.
void paint_shadows(Canvas& canvas, const Scene& scene, const Placement& place) {
  const CellFace& base = cell_faces(scene.lattice)[bottom_face(scene.lattice)];
  for (const double spread : {0.8, 1.0, 1.2}) {
    canvas.begin_group();
    for (const Cell& cell : scene.shadowing) {
      const Corner foot = foot_of(scene.lattice, cell);
      std::vector<PagePoint> corners;
      for (std::size_t i = 0; i < static_cast<std::size_t>(base.corners); ++i) {
        const Point p = position(scene.lattice, foot + base.corner[i]);
        for (const double height : {p.z, p.z + 1}) {
          const Point away = shadow_of(scene.lattice, spread * height);
          corners.push_back(placed(place, project(scene.lattice, {p.x + away.x, p.y + away.y, 0})));
        }
      }
      const std::vector<PagePoint> hull = convex_hull(std::move(corners));
      canvas.polygon(hull.data(), hull.size(), kShadow, kShadow, 0.5);
    }
    canvas.end_group(0.055);
  }
}

Rgb shaded(Rgb colour, Side side) {
  switch (side) {
    case Side::top:
      return blend(colour, kWhite, 0.16);
    case Side::left:
      return blend(colour, kBlack, 0.08);
    case Side::right:
      return blend(colour, kBlack, 0.28);
  }
  return colour;
}

// Edges are darker than their face where cells are large, and fade into it where
// they are small; there they only close the seams between faces.
struct EdgeLook {
  double dark, width;
};
EdgeLook edge_look(double scale) {
  return {0.38 * std::clamp((scale - 3) / 12, 0.0, 1.0), std::clamp(scale / 45, 0.6, 1.5)};
}

}  // namespace

void Frame::add(PagePoint p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

Scene make_scene(const Structure& structure, bool floor) {
  Scene scene;
  scene.lattice = structure.lattice();
  scene.floor = floor;
  scene.faces = shown_faces(structure);
  scene.box = structure.bounds().value_or(Bounds{});
  if (floor) {
    const std::vector<PlacedBrick> bricks = structure.bricks();
    if (bricks.size() <= kMostShadows) {
      for (const PlacedBrick& brick : bricks) scene.shadowing.push_back(brick.at);
    }
    if (scene.lattice == Lattice::hexagonal) scene.tiles = tiles_under(bricks);
  }
  find_frame(scene);
  return scene;
}

void share_frame(std::vector<Scene>& scenes) {
  Scene all = scenes.front();
  for (const Scene& scene : scenes) {
    extend(all.box, scene.box);
    all.tiles.insert(all.tiles.end(), scene.tiles.begin(), scene.tiles.end());
    all.frame.add(scene.frame.low);
    all.frame.add(scene.frame.high);
  }
  std::sort(all.tiles.begin(), all.tiles.end());
  all.tiles.erase(std::unique(all.tiles.begin(), all.tiles.end()), all.tiles.end());
  find_frame(all);
  for (Scene& scene : scenes) {
    scene.box = all.box;
    scene.tiles = all.tiles;
    scene.frame = all.frame;
  }
}

void paint_scene(Canvas& canvas, const Scene& scene, const Placement& place,
                 const std::vector<Brick>& bricks) {
  if (scene.floor) {
    paint_ground(canvas, scene, place);
    if (!scene.shadowing.empty()) paint_shadows(canvas, scene, place);
  }
  const EdgeLook look = edge_look(place.scale);
  for (const ShownFace& face : scene.faces) {
    const Rgb fill = shaded(rgb_of(bricks, face.colour), face.side);
    paint(canvas, place, outline_of(scene.lattice, face.at, face.face), fill,
          blend(fill, kBlack, look.dark), look.width);
  }
}

void paint_swatch(Canvas& canvas, Lattice lattice, PagePoint centre, double radius, Rgb colour) {
  const Structure cell(lattice, {{{0, 0, 0}, 1}});
  const PagePoint middle = project(lattice, {0, 0, 0.5});
  const double scale = 1.2 * radius;
  const Placement place{scale, {centre.x - scale * middle.x, centre.y - scale * middle.y}};
  for (const ShownFace& face : shown_faces(cell)) {
    const Rgb fill = shaded(colour, face.side);
    paint(canvas, place, outline_of(lattice, face.at, face.face), fill, blend(fill, kBlack, 0.25),
          0.8);
  }
}

}  // namespace stig
