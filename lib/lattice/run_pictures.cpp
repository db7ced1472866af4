// SPDX-License-Identifier: MIT
// The page is laid out once, for the whole. It is made as if it had at least 720 by 480 units and
// then scaled to the pixels that are wanted, so that small pictures have small letters.
#include "lattice/run_pictures.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::lattice {

namespace {

constexpr double kLeastWide = 720, kLeastHigh = 480;  ///< units
constexpr std::size_t kManyShown = 20000;
constexpr double kEdge = 28, kTitleHeight = 40, kCaptionHeight = 26;

PageSize page_of(const RunPictureOptions& options) {
  const double density = std::min(options.width / kLeastWide, options.height / kLeastHigh);
  return {options.width, options.height, density};
}

/// Visits the corners of the cells of all bricks.
template <class Visit>
void each_corner(const Structure& structure, const Visit& visit) {
  const Lattice lattice = structure.lattice();
  structure.for_each([&](Cell cell, State) {
    const Corner foot = foot_of(lattice, cell);
    // Top and bottom have all corners of a cell between them.
    for (const std::size_t face : {bottom_face(lattice), bottom_face(lattice) - 1}) {
      const CellFace& shape = cell_faces(lattice)[face];
      for (std::size_t i = 0; i < static_cast<std::size_t>(shape.corners); ++i) {
        visit(position(lattice, foot + shape.corner[i]));
      }
    }
  });
}

Colour highest(const ColourCounts& counts) {
  return counts.empty() ? Colour{0} : counts.rbegin()->first;
}

}  // namespace

RunPictures::RunPictures(Structure whole, const std::vector<Brick>& bricks,
                         RunPictureOptions options)
    : whole_(std::move(whole)), options_(std::move(options)), page_(page_of(options_)) {
  assert(options_.width > 0 && options_.height > 0);
  count_colours(whole_, counts_);
  bricks_ = recoloured(bricks, options_.palette, highest(counts_));
  stage_ = make_scene(whole_, options_.floor, camera(0));
  if (options_.orbit) find_round();
  drawing_top_ = kEdge + (options_.title.empty() ? 0 : kTitleHeight);
  caption_base_ = page_.units_high() - kEdge + 8;
  legend_top_ = caption_base_ - (options_.title.empty() ? 8 : kCaptionHeight);
  if (!options_.legend) return;
  // With the counts of the whole, which are the widest.
  const double height = place_legend(legend_items(counts_, bricks_, true), kEdge + kAxes,
                                     page_.units_wide() - kEdge, legend_places_);
  legend_top_ -= std::max(height, kAxes - 26);
}

LatticeCamera RunPictures::camera(double turn) const {
  return camera_at(whole_.lattice(), options_.azimuth + turn, options_.elevation);
}

// The upright cylinder about everything that is drawn looks the same from all around.
void RunPictures::find_round() {
  const auto each_point = [&](const auto& visit) {
    each_corner(whole_, visit);
    if (stage_.floor && stage_.lattice == Lattice::cubic) {
      for (const Corner& c : ground_corners(stage_.box)) visit(position(stage_.lattice, c));
    }
    for (const Cell& tile : stage_.tiles) visit(embed(stage_.lattice, tile));
    if (whole_.empty()) visit(Point{0, 0, 1});
  };
  Point low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  each_point([&](const Point& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  });
  round_ = {{(low.x + high.x) / 2, (low.y + high.y) / 2, 0}, 0.5, low.z, high.z};
  each_point([&](const Point& p) {
    const double away = std::hypot(p.x - round_.pivot.x, p.y - round_.pivot.y);
    round_.radius = std::max(round_.radius, away);
  });
}

PictureFrame RunPictures::frame_from(const LatticeCamera& camera) const {
  if (!options_.orbit) return stage_.frame;
  const PagePoint pivot = project(camera, round_.pivot);
  const double deep = round_.radius * std::abs(camera.towards.z);
  PictureFrame frame;
  frame.add({pivot.x - round_.radius, pivot.y - deep - round_.high * camera.up.z});
  frame.add({pivot.x + round_.radius, pivot.y + deep - round_.low * camera.up.z});
  return frame;
}

std::string RunPictures::draw(const Structure& now, const std::string& caption, double turn) const {
  assert(options_.orbit || turn == 0);
  const LatticeCamera from = camera(turn);
  PictureScene scene = make_scene(now, options_.floor, from, options_.ghost ? &whole_ : nullptr);
  if (options_.format == PictureFormat::svg && scene.faces.size() > kMostSvgFaces) return {};
  scene.box = stage_.box;
  scene.tiles = stage_.tiles;
  const PictureFrame frame = frame_from(from);
  const double wide = page_.units_wide() - 2 * kEdge, high = legend_top_ - 10 - drawing_top_;
  const double scale = std::min(wide / std::max(frame.width(), 1e-9),
                                std::max(high, 64.0) / std::max(frame.height(), 1e-9));
  const PicturePlacement place{
      scale,
      {page_.units_wide() / 2 - scale * (frame.low.x + frame.high.x) / 2,
       drawing_top_ + high / 2 - scale * (frame.low.y + frame.high.y) / 2}};
  Canvas canvas(options_.format, page_);
  // As in picture.cpp: of few faces, finding the covered ones costs more than painting them.
  if (scene.faces.size() > kManyShown) {
    drop_covered(scene, place, page_.units_wide(), page_.units_high());
  }
  paint_scene(canvas, scene, place, bricks_);
  draw_marks(canvas, now, from);
  if (!caption.empty()) write_fitting(canvas, caption, {kEdge, caption_base_}, kCaptionLook, wide);
  return canvas.finish();
}

void RunPictures::draw_marks(Canvas& canvas, const Structure& now,
                             const LatticeCamera& camera) const {
  if (!options_.title.empty()) {
    write_fitting(canvas, options_.title, {kEdge, kEdge + 18}, kTitleLook,
                  page_.units_wide() - 2 * kEdge);
  }
  if (!options_.legend) return;
  const Lattice lattice = whole_.lattice();
  const auto along = [&](Offset axis) { return project(camera, embed(lattice, Cell{} + axis)); };
  paint_axes(canvas, lattice, {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})},
             {kEdge + 32, legend_top_ + 34});
  // Every colour has its place from the beginning.
  ColourCounts counts;
  for (const auto& [colour, count] : counts_) counts[colour] = 0;
  count_colours(now, counts);
  paint_legend(canvas, lattice, legend_items(counts, bricks_, true), legend_places_, legend_top_,
               bricks_);
}

}  // namespace stig::lattice
