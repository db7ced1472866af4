// SPDX-License-Identifier: MIT
// Triangles to pixels, the nearer before the farther: a z-buffer and nothing else. Where
// corners appear is for the caller to know (sensing/camera.h), so that pictures for people
// and what a robot's camera sees are made by the same code.
#pragma once

#include <cstdint>
#include <vector>

#include "base/rgb.h"
#include "physical/render/uses.h"

namespace stig::physics {

struct Image {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;  ///< row by row from the top

  const Rgb& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// On the image: pixels from the upper left corner, whose first pixel's middle is (0, 0), and
/// one over the depth in m, which is linear over a triangle.
struct RasterPoint {
  double x = 0, y = 0, inverse_depth = 0;
};

class Raster {
 public:
  Raster(int width, int height, Rgb background);

  int width() const { return image_.width; }
  int height() const { return image_.height; }

  /// Covers what is farther away. Either way round.
  void triangle(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, Rgb colour);
  /// So many pixels wide; drawn as if nearer by the share `bias`, so that it is seen upon the
  /// surface it lies in.
  void line(const RasterPoint& a, const RasterPoint& b, double width, Rgb colour, double bias);
  /// Darkens what is not nearer, each pixel once however many triangles cover it: a shadow.
  void shade(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, double darkness);

  /// As it is, or each square of `samples` by `samples` pixels as one.
  Image image(int samples = 1) const;

 private:
  template <class Paint>
  void fill(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, Paint paint);

  Image image_;
  std::vector<float> inverse_depth_;
  std::vector<std::uint8_t> shaded_;
};

}  // namespace stig::physics
