// SPDX-License-Identifier: MIT
// Paints a scene back to front (the painter's algorithm); faces come sorted by view.h.
// Shadows are projections on the ground along one direction of light; three sheets of
// slightly different directions make them softer the higher their bricks are.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "lattice/picture_scene.h"
#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

constexpr Rgb kGround{0xf4, 0xf6, 0xf8}, kGroundLine{0xdd, 0xe2, 0xe8};
constexpr Rgb kShadow{0x20, 0x2a, 0x38}, kBlack{0, 0, 0}, kWhite{255, 255, 255};

// Light comes from the left, in front and above; where the ground is that a point
// one cell up throws its shadow on.
Point shadow_of(Lattice lattice, double height) {
  if (lattice == Lattice::cubic) return {0.12 * height, 0.35 * height, 0};
  const Point along = embed(lattice, {0, 1, 0});
  return {0.3 * height * along.x, 0.3 * height * along.y, 0};
}

PagePoint placed(const PicturePlacement& place, PagePoint p) {
  return {place.origin.x + place.scale * p.x, place.origin.y + place.scale * p.y};
}

void paint(Canvas& canvas, const PicturePlacement& place, const Outline& outline, Rgb fill,
           Rgb edge, double width, double opacity = 1) {
  std::array<PagePoint, 6> corners{};
  for (std::size_t i = 0; i < outline.count; ++i) corners[i] = placed(place, outline.at[i]);
  canvas.polygon(corners.data(), outline.count, fill, edge, width, opacity);
}

// Cells between two lines of the ground: 1, 2, 5, 10, … so that lines stay apart. The factor
// after each 2 is 5/2, and 2 otherwise.
int line_step(double scale) {
  constexpr double kClosest = 4;
  int step = 1;
  for (int i = 0; step * scale < kClosest && step < (1 << 24); ++i)
    step = step * (i % 3 == 1 ? 5 : 4) / 2;
  return step;
}

/// Lines are drawn in corner coordinates, which count half cells, hence twice the step.
void paint_cubic_ground(Canvas& canvas, const PictureScene& scene, const PicturePlacement& place) {
  const auto corners = ground_corners(scene.box);
  const auto at = [&](std::int32_t x, std::int32_t y) {
    return placed(place, on_page(scene, {x, y, 0}));
  };
  const std::array<PagePoint, 4> outline = {
      at(corners[0].x, corners[0].y), at(corners[1].x, corners[1].y),
      at(corners[2].x, corners[2].y), at(corners[3].x, corners[3].y)};
  canvas.polygon(outline.data(), outline.size(), kGround, kGroundLine, 0.8);
  const int step = 2 * line_step(place.scale);
  const Corner low = corners[0], high = corners[2];
  for (int x = low.x + step; x < high.x; x += step) {
    canvas.line(at(x, low.y), at(x, high.y), kGroundLine, 0.8);
  }
  for (int y = low.y + step; y < high.y; y += step) {
    canvas.line(at(low.x, y), at(high.x, y), kGroundLine, 0.8);
  }
}

void paint_ground(Canvas& canvas, const PictureScene& scene, const PicturePlacement& place) {
  if (scene.lattice == Lattice::cubic) return paint_cubic_ground(canvas, scene, place);
  const double width = place.scale < 4 ? 0.4 : 0.8;
  const Rgb edge = place.scale < 4 ? kGround : kGroundLine;
  for (const Cell& tile : scene.tiles) {
    paint(canvas, place, outline_of(scene, tile, bottom_face(scene.lattice)), kGround, edge, width);
  }
}

double cross(PagePoint o, PagePoint a, PagePoint b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// The monotone chain of A. Andrew, "Another efficient algorithm for convex hulls in two
// dimensions" (Information Processing Letters, 1979).
std::vector<PagePoint> convex_hull(std::vector<PagePoint> points) {
  assert(points.size() >= 3);
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
void paint_shadows(Canvas& canvas, const PictureScene& scene, const PicturePlacement& place) {
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
          corners.push_back(placed(place, project(scene.camera, {p.x + away.x, p.y + away.y, 0})));
        }
      }
      const std::vector<PagePoint> hull = convex_hull(std::move(corners));
      canvas.polygon(hull.data(), hull.size(), kShadow, kShadow, 0.5);
    }
    canvas.end_group(0.055);
  }
}

// Which pixels of the canvas have their centre in a face already. A coverage buffer at the
// resolution of the picture. A face is dropped only if all pixels within its box are
// covered, so it may keep a hidden face, and drops a visible one only where less than a
// pixel of it shows.
class CoverMap {
 public:
  CoverMap(double width, double height)
      : columns_(static_cast<int>(width * Canvas::kDensity) + 1),
        rows_(static_cast<int>(height * Canvas::kDensity) + 1),
        covered_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  /// Whether some of the face, in canvas units, is uncovered; covers it.
  bool add(const Outline& face) {
    Outline at = face;
    PictureFrame box;
    for (std::size_t i = 0; i < at.count; ++i) {
      at.at[i] = {at.at[i].x * Canvas::kDensity, at.at[i].y * Canvas::kDensity};
      box.add(at.at[i]);
    }
    const bool tiny = box.width() < 1 && box.height() < 1;  // then one pixel stands for it
    const int left = column(tiny ? (box.low.x + box.high.x) / 2 : box.low.x);
    const int right = tiny ? left : column(box.high.x);
    const int top = row(tiny ? (box.low.y + box.high.y) / 2 : box.low.y);
    const int bottom = tiny ? top : row(box.high.y);
    bool shows = false;
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        char& pixel = covered_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(x)];
        if (pixel != 0) continue;
        shows = true;
        pixel = tiny || inside(at, {x + 0.5, y + 0.5});
      }
    }
    return shows;
  }

 private:
  int column(double x) const { return std::clamp(static_cast<int>(x), 0, columns_ - 1); }
  int row(double y) const { return std::clamp(static_cast<int>(y), 0, rows_ - 1); }

  // Convex outlines alone; either direction.
  static bool inside(const Outline& outline, PagePoint p) {
    int left = 0, right = 0;
    for (std::size_t i = 0; i < outline.count; ++i) {
      const double side = cross(outline.at[i], outline.at[(i + 1) % outline.count], p);
      (side >= 0 ? left : right) += 1;
    }
    return left == 0 || right == 0;
  }

  int columns_, rows_;
  std::vector<char> covered_;
};

/// Share of black in the sides of a cell, in the order of cell_faces. Fixed shades give the
/// impression of light without computing any; they belong to the structure, so that its sides keep
/// theirs while the viewer goes round it.
double darkness(Lattice lattice, std::size_t face) {
  constexpr std::array<double, 4> kCubic = {0.28, 0.16, 0.36, 0.08};
  constexpr std::array<double, 6> kHexagonal = {0.28, 0.40, 0.36, 0.18, 0.04, 0.08};
  constexpr double kBelow = 0.45;
  const bool cubic = lattice == Lattice::cubic;
  if (face >= bottom_face(lattice)) return kBelow;
  return cubic ? kCubic.at(face) : kHexagonal.at(face);
}

Rgb shaded(Rgb colour, Lattice lattice, std::size_t face) {
  if (face + 1 == bottom_face(lattice)) return blend(colour, kWhite, 0.16);  // the top
  return blend(colour, kBlack, darkness(lattice, face));
}

constexpr double kGhost = 0.13;  ///< opacity

// Edges are darker than their face where cells are large, and fade into it where
// they are small; there they only close the seams between faces.
struct EdgeLook {
  double dark, width;
};
EdgeLook edge_look(double scale) {
  return {0.38 * std::clamp((scale - 1.5) / 6, 0.0, 1.0), std::clamp(scale / 45, 0.35, 1.2)};
}

}  // namespace

void drop_covered(PictureScene& scene, const PicturePlacement& place, double width, double height) {
  assert(width > 0 && height > 0);
  CoverMap map(width, height);
  std::vector<ShownFace> kept;
  // From the nearest face to the farthest, against the order of painting.
  for (auto face = scene.faces.rbegin(); face != scene.faces.rend(); ++face) {
    if (face->ghost) {  // one sees through it
      kept.push_back(*face);
      continue;
    }
    Outline outline = outline_of(scene, face->at, face->face);
    for (std::size_t i = 0; i < outline.count; ++i) {
      outline.at[i] = placed(place, outline.at[i]);
    }
    if (map.add(outline)) kept.push_back(*face);
  }
  scene.faces.assign(kept.rbegin(), kept.rend());
}

void paint_scene(Canvas& canvas, const PictureScene& scene, const PicturePlacement& place,
                 const std::vector<Brick>& bricks) {
  if (scene.floor) {
    paint_ground(canvas, scene, place);
    if (!scene.shadowing.empty()) paint_shadows(canvas, scene, place);
  }
  const EdgeLook look = edge_look(place.scale);
  for (const ShownFace& face : scene.faces) {
    const Rgb fill = shaded(rgb_of(bricks, face.colour), scene.lattice, face.face);
    paint(canvas, place, outline_of(scene, face.at, face.face), fill,
          blend(fill, kBlack, look.dark), look.width, face.ghost ? kGhost : 1);
  }
}

/// The swatch is a small picture of one brick, painted by the same code as the structure.
void paint_swatch(Canvas& canvas, Lattice lattice, PagePoint centre, double radius, Rgb colour) {
  const PictureScene cell =
      make_scene(Structure(lattice, {{{0, 0, 0}, 1}}), false, usual_camera(lattice));
  const PagePoint middle = project(lattice, {0, 0, 0.5});
  const double scale = 1.2 * radius;
  const PicturePlacement place{scale, {centre.x - scale * middle.x, centre.y - scale * middle.y}};
  for (const ShownFace& face : cell.faces) {
    const Rgb fill = shaded(colour, lattice, face.face);
    paint(canvas, place, outline_of(cell, face.at, face.face), fill, blend(fill, kBlack, 0.25),
          0.8);
  }
}

}  // namespace stig::lattice
