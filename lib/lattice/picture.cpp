// SPDX-License-Identifier: MIT
// Lays out and draws a page: title, panels, axes, legend and caption. All measures are in
// units of the canvas, two pixels each in a .png. The layout is computed in full before
// anything is drawn, so the page has the size that it needs, and text that is too wide is
// scaled and never cut.
#include "lattice/picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lattice/canvas.h"
#include "lattice/picture_marks.h"
#include "lattice/picture_scene.h"
#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

/// Lengths in units of the canvas. They were chosen by eye, and pictures in the
/// documentation depend on them.
constexpr double kMargin = 28;
constexpr std::size_t kManyFaces = 20000;  // then it pays to find the covered ones
constexpr double kGap = 24;                // between panels
constexpr double kSmallestWidth = 304, kWidestLegend = 480;  // of what is in the margins
constexpr TextLook kLabel{14, false, {0x1f, 0x29, 0x33}};

// Where everything goes, in units of the canvas. All figures are computed once; drawing
// only reads them.
struct Layout {
  double scale = 1;  // units a cell
  int columns = 1, rows = 1;
  double panel_width = 0, panel_height = 0;  // of the drawing in a panel
  double label_height = 0;
  double drawing_top = 0, legend_top = 0, caption_base = 0;
  std::vector<PagePoint> legend_places;  // left end of each item's base line
  double width = 0, height = 0;
};

// The number of rows that lets cells be largest; the fewer where it is nearly equal. Tries
// every number of rows and keeps the largest scale; one per cent better is not worth
// another row.
void fit_panels(Layout& layout, std::size_t panels, PagePoint content, PagePoint room,
                double most_scale) {
  assert(content.x > 0 && content.y > 0);
  layout.scale = 0;
  const int count = static_cast<int>(panels);
  for (int rows = 1; rows <= count; ++rows) {
    const int columns = (count + rows - 1) / rows;
    const double width = (room.x - kGap * (columns - 1)) / columns;
    const double height =
        (room.y - (kGap + layout.label_height) * (rows - 1)) / rows - layout.label_height;
    const double scale = std::min({width / content.x, height / content.y, most_scale});
    if (scale <= layout.scale * 1.01) continue;
    layout.scale = scale;
    layout.columns = columns;
    layout.rows = rows;
  }
  layout.panel_width = content.x * layout.scale;
  layout.panel_height = content.y * layout.scale;
}

Colour most_colour(const std::vector<PicturePanel>& panels) {
  Colour most = 0;
  for (const PicturePanel& panel : panels) {
    panel.structure->for_each([&](Cell, State state) { most = std::max<Colour>(most, state); });
  }
  return most;
}

// One legend for all panels. Counts are shown for a single one; for several they would be sums of
// no interest.
std::vector<LegendItem> legend_of(const std::vector<PicturePanel>& panels,
                                  const std::vector<Brick>& bricks) {
  ColourCounts counts;
  for (const PicturePanel& panel : panels) count_colours(*panel.structure, counts);
  return legend_items(counts, bricks, panels.size() == 1);
}

class Picture {
 public:
  Picture(const std::vector<PicturePanel>& panels, const std::vector<Brick>& bricks,
          const PictureOptions& options)
      : panels_(panels),
        bricks_(recoloured(bricks, options.palette, most_colour(panels))),
        options_(options) {
    for (const PicturePanel& panel : panels_) {
      scenes_.push_back(make_scene(turned(*panel.structure, options.turns), options.floor,
                                   usual_camera(panel.structure->lattice())));
    }
    if (options.same_frame) share_frame(scenes_);
    if (options.legend) items_ = legend_of(panels, bricks_);
    lay_out();
  }

  std::string draw() {
    std::size_t faces = 0;
    for (const PictureScene& scene : scenes_) faces += scene.faces.size();
    if (options_.format == PictureFormat::svg && faces > kMostSvgFaces) return {};
    Canvas canvas(options_.format, static_cast<int>(layout_.width),
                  static_cast<int>(layout_.height));
    if (!options_.title.empty()) {
      write_fitting(canvas, options_.title, {kMargin, kMargin + 18}, kTitleLook, room());
    }
    for (std::size_t i = 0; i < scenes_.size(); ++i) draw_panel(canvas, i);
    if (options_.axes) draw_axes(canvas);
    paint_legend(canvas, scenes_.front().lattice, items_, layout_.legend_places, layout_.legend_top,
                 bricks_);
    if (!options_.caption.empty()) {
      write_fitting(canvas, options_.caption, {kMargin, layout_.caption_base}, kCaptionLook,
                    room());
    }
    return canvas.finish();
  }

 private:
  // The scale depends on the room that the legend leaves, and the legend's rows on the
  // page's width: the number of rows is estimated first from its total length.
  void lay_out() {
    const double most = options_.most_pixels / static_cast<double>(Canvas::kDensity);
    PagePoint content{1e-9, 1e-9};
    for (const PictureScene& scene : scenes_) {
      content.x = std::max(content.x, scene.frame.width());
      content.y = std::max(content.y, scene.frame.height());
    }
    layout_.drawing_top = kMargin + (options_.title.empty() ? 0 : 40);
    for (const PicturePanel& panel : panels_) {
      if (!panel.label.empty()) layout_.label_height = 26;
    }
    double legend_row = options_.axes ? kAxes : 0;
    for (const LegendItem& item : items_) legend_row += item.width;
    const double legend_rows = std::ceil(legend_row / (most - 2 * kMargin - kAxes));
    const double below = std::max(options_.axes ? kAxes : 0, legend_rows * kLegendRow) +
                         (options_.caption.empty() ? 1 : 2) * kMargin;
    fit_panels(layout_, panels_.size(), content,
               {most - 2 * kMargin, std::max(most - layout_.drawing_top - below, 64.0)},
               options_.cell_pixels / Canvas::kDensity);
    const double drawing = layout_.columns * layout_.panel_width + kGap * (layout_.columns - 1);
    const double words = std::max({text_width(options_.title, kTitleLook),
                                   text_width(options_.caption, kCaptionLook),
                                   std::min(legend_row, kWidestLegend), kSmallestWidth});
    layout_.width =
        std::ceil(std::min(std::max(drawing, words) + 2 * kMargin, std::max(most, kSmallestWidth)));
    const double row = layout_.panel_height + layout_.label_height;
    layout_.legend_top = layout_.drawing_top + row * layout_.rows + kGap * (layout_.rows - 1) + 18;
    const double left = kMargin + (options_.axes ? kAxes : 0);
    const double legend =
        place_legend(items_, left, layout_.width - kMargin, layout_.legend_places);
    double bottom = layout_.legend_top + std::max(legend, options_.axes ? kAxes - 26 : 0);
    if (!options_.caption.empty()) {
      layout_.caption_base = bottom + 22;
      bottom = layout_.caption_base;
    }
    layout_.height = std::ceil(bottom + kMargin - 8);
  }

  double room() const { return layout_.width - 2 * kMargin; }

  void draw_panel(Canvas& canvas, std::size_t i) {
    PictureScene& scene = scenes_[i];
    const auto columns = static_cast<std::size_t>(layout_.columns);
    const double drawing = layout_.columns * layout_.panel_width + kGap * (layout_.columns - 1);
    const double left = (layout_.width - drawing) / 2 +
                        static_cast<double>(i % columns) * (layout_.panel_width + kGap);
    const double bottom =
        layout_.drawing_top + layout_.panel_height +
        static_cast<double>(i / columns) * (layout_.panel_height + layout_.label_height + kGap);
    const PicturePlacement place{layout_.scale,
                                 {left + layout_.panel_width / 2 -
                                      layout_.scale * (scene.frame.low.x + scene.frame.high.x) / 2,
                                  bottom - layout_.scale * scene.frame.high.y}};
    // Hidden faces cost time to paint, and more in an .svg; for small scenes finding them
    // costs more.
    if (scene.faces.size() > kManyFaces) {
      drop_covered(scene, place, layout_.width, layout_.height);
    }
    paint_scene(canvas, scene, place, bricks_);
    const std::string& label = panels_[i].label;
    TextLook look = kLabel;
    const double width = text_width(label, look);
    if (width > layout_.panel_width + kGap) look.size *= (layout_.panel_width + kGap) / width;
    canvas.text(label, {left + (layout_.panel_width - text_width(label, look)) / 2, bottom + 20},
                look);
  }

  // The axes turn with the structure, so that they name its directions and not the page's.
  void draw_axes(Canvas& canvas) const {
    const Lattice lattice = scenes_.front().lattice;
    const auto group = orientations(lattice, Symmetry::rotations, false);
    const auto count = static_cast<int>(group.size());
    const Orientation& turn =
        group[static_cast<std::size_t>((options_.turns % count + count) % count)];
    const auto along = [&](Offset axis) {
      return project(lattice, embed(lattice, Cell{} + turn.apply(axis)));
    };
    paint_axes(canvas, lattice, {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})},
               {kMargin + 32, layout_.legend_top + 34});
  }

  const std::vector<PicturePanel>& panels_;
  const std::vector<Brick> bricks_;
  const PictureOptions& options_;
  std::vector<PictureScene> scenes_;
  std::vector<LegendItem> items_;
  Layout layout_;
};

}  // namespace

std::string draw_structure(const Structure& structure, const std::vector<Brick>& bricks,
                           const PictureOptions& options) {
  return draw_structures({{&structure, ""}}, bricks, options);
}

std::string draw_structures(const std::vector<PicturePanel>& panels,
                            const std::vector<Brick>& bricks, const PictureOptions& options) {
  assert(!panels.empty());
  return Picture(panels, bricks, options).draw();
}

}  // namespace stig::lattice
