// SPDX-License-Identifier: MIT
// Each polygon gets a thin edge of its own colour, which closes the seam that smooth borders leave
// between two of them.
#include "view/pose_svg.h"

#include <algorithm>
#include <array>

#include "lattice/canvas.h"
#include "physical/render/painting_order.h"

namespace stig::view {

namespace {

constexpr double kSeam = 0.4;                  ///< pixels
constexpr double kLetters = 22, kMargin = 20;  ///< pixels, of a picture of kUsualWidth
constexpr double kUsualWidth = 1200, kSmallestLetters = 10;

class Drawing final : public PictureSink {
 public:
  explicit Drawing(Canvas& canvas) : canvas_(canvas) {}

  void polygon(const std::vector<RasterPoint>& corners, Rgb colour) override {
    end_shadows();
    fill(corners, colour, kSeam);
  }
  /// Shadows stand together: one sheet of them, so that none is darker where two fall.
  void shadow(const std::vector<RasterPoint>& corners, double darkness) override {
    if (!darkness_) canvas_.begin_group();
    darkness_ = darkness;
    fill(corners, {0, 0, 0}, 0);
  }
  void line(const RasterPoint& from, const RasterPoint& to, double width, Rgb colour,
            double /*bias*/) override {
    end_shadows();
    ++count_;
    canvas_.line(on_page(from), on_page(to), colour, width);
  }
  void end_shadows() {
    if (darkness_) canvas_.end_group(*darkness_);
    darkness_.reset();
  }
  std::size_t count() const { return count_; }

 private:
  /// The middle of the first pixel is at half a unit.
  static PagePoint on_page(const RasterPoint& p) { return {p.x + 0.5, p.y + 0.5}; }

  void fill(const std::vector<RasterPoint>& corners, Rgb colour, double edge) {
    ++count_;
    std::vector<PagePoint> outline;
    for (const RasterPoint& corner : corners) outline.push_back(on_page(corner));
    canvas_.polygon(outline.data(), outline.size(), colour, colour, edge);
  }

  Canvas& canvas_;
  std::optional<double> darkness_;  ///< of the sheet of shadows that is open
  std::size_t count_ = 0;
};

void write_caption(Canvas& canvas, const std::string& caption, int width, int height) {
  TextLook look;
  look.size = std::max(kLetters * width / kUsualWidth, kSmallestLetters);
  const double margin = kMargin * look.size / kLetters;
  canvas.text(caption, {margin, height - margin}, look);
}

}  // namespace

std::string pose_svg(const std::vector<PictureBody>& bodies, const PictureView& view,
                     const std::optional<PictureFloor>& floor,
                     const std::vector<PictureLine>& lines, const std::string& caption) {
  const double width = view.camera.width, height = view.camera.height;
  Canvas canvas(PictureFormat::svg, PageSize{view.camera.width, view.camera.height, 1});
  const std::array<PagePoint, 4> page = {{{0, 0}, {width, 0}, {width, height}, {0, height}}};
  canvas.polygon(page.data(), page.size(), kBackdrop, kBackdrop, 0);
  Drawing drawing(canvas);
  paint_bodies(drawing, painting_order(bodies, view), view, floor, lines);
  drawing.end_shadows();
  if (drawing.count() > kMostSvgFaces) return {};
  if (!caption.empty()) write_caption(canvas, caption, view.camera.width, view.camera.height);
  return canvas.finish();
}

}  // namespace stig::view
