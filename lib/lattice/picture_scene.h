// SPDX-License-Identifier: MIT
// What a picture shows of one structure, before and apart from the page: faces,
// ground and shadows in cell widths, and how they are painted.
#pragma once

#include <array>
#include <vector>

#include "lattice/canvas.h"
#include "lattice/uses.h"
#include "lattice/view.h"

namespace stig::lattice {

/// A rectangle of the projected page, in cell widths; empty until something is added.
struct PictureFrame {
  PagePoint low{1e300, 1e300}, high{-1e300, -1e300};
  void add(PagePoint p);
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};

struct PictureScene {
  Lattice lattice = Lattice::cubic;
  LatticeCamera camera{};
  bool floor = false;
  std::vector<ShownFace> faces;
  std::vector<Cell> shadowing;  ///< bricks that throw a shadow; none when too many
  CellBounds box{};             ///< of the structure; one cell when empty
  std::vector<Cell> tiles;      ///< hexagonal ground: the cells it consists of
  PictureFrame frame;
};

/// The ground is drawn for viewers above it alone. `to_come`: as with shown_faces.
PictureScene make_scene(const Structure& structure, bool floor, const LatticeCamera& camera,
                        const Structure* to_come = nullptr);

/// Gives all scenes the box, and so the frame and ground, of all together.
void share_frame(std::vector<PictureScene>& scenes);

/// A face on the page.
struct Outline {
  std::array<PagePoint, 6> at{};
  std::size_t count = 0;
};
Outline outline_of(const PictureScene& scene, Cell cell, std::size_t face);
/// Index into cell_faces of the face that looks down.
std::size_t bottom_face(Lattice lattice);
PagePoint on_page(const PictureScene& scene, Corner corner);
/// Cubic ground: the box's floor with a margin, wider where shadows fall.
std::array<Corner, 4> ground_corners(const CellBounds& box);

/// Where a scene's page lies on the canvas: a point p is drawn at origin + scale·p.
struct PicturePlacement {
  double scale = 1;
  PagePoint origin;
};
/// Leaves out faces that nearer ones cover, pixel for pixel, on a canvas of the given
/// size: of a million loose bricks, nine in ten.
void drop_covered(PictureScene& scene, const PicturePlacement& place, double width, double height);

void paint_scene(Canvas& canvas, const PictureScene& scene, const PicturePlacement& place,
                 const std::vector<Brick>& bricks);

/// A single cell of the colour around `centre`, `radius` pixels in size.
void paint_swatch(Canvas& canvas, Lattice lattice, PagePoint centre, double radius, Rgb colour);

}  // namespace stig::lattice
