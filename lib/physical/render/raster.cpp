// SPDX-License-Identifier: MIT
// A software rasteriser with a depth buffer: triangles by barycentric coordinates (Pineda 1988), as
// precise as doubles and the same on every machine. Depth is kept as its inverse, which is linear
// over the image where depth is not, and 0 is infinitely far.
#include "physical/render/raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::physics {

namespace {

/// Twice the area of a triangle, with a sign for its sense.
double area(const RasterPoint& a, const RasterPoint& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// First and last whole number in [low, high] that is a pixel of 0..size-1.
int first_pixel(double low, int size) {
  // Clamped before the cast, since casting what no int can hold is undefined.
  return static_cast<int>(std::ceil(std::clamp(low, 0.0, static_cast<double>(size))));
}
int last_pixel(double high, int size) {
  return static_cast<int>(std::floor(std::clamp(high, -1.0, size - 1.0)));
}

bool finite(const RasterPoint& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.inverse_depth);
}

}  // namespace

Raster::Raster(int width, int height, Rgb background) {
  assert(width > 0 && height > 0);
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image_ = {width, height, std::vector<Rgb>(size, background)};
  inverse_depth_.assign(size, 0);
  shaded_.assign(size, 0);
}

template <class Paint>
void Raster::fill(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c, Paint paint) {
  // All three edge functions divided by the whole area are the point's barycentric coordinates;
  // that takes both senses of a triangle in one.
  const double whole = area(a, b, c.x, c.y);
  if (whole == 0 || !std::isfinite(whole) || !finite(a) || !finite(b) || !finite(c)) return;
  const int low_y = first_pixel(std::min({a.y, b.y, c.y}), image_.height);
  const int high_y = last_pixel(std::max({a.y, b.y, c.y}), image_.height);
  const int low_x = first_pixel(std::min({a.x, b.x, c.x}), image_.width);
  const int high_x = last_pixel(std::max({a.x, b.x, c.x}), image_.width);
  for (int y = low_y; y <= high_y; ++y) {
    for (int x = low_x; x <= high_x; ++x) {
      const double u = area(b, c, x, y) / whole, v = area(c, a, x, y) / whole, w = 1 - u - v;
      // Points on an edge belong to both triangles beside it: no gaps, and the second paints over.
      if (u < 0 || v < 0 || w < 0) continue;
      const double near = u * a.inverse_depth + v * b.inverse_depth + w * c.inverse_depth;
      paint(static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                static_cast<std::size_t>(x),
            static_cast<float>(near));
    }
  }
}

void Raster::triangle(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c,
                      Rgb colour) {
  fill(a, b, c, [&](std::size_t pixel, float near) {
    // Equally near: the later one, so that edges and marks drawn after a face are seen.
    if (near < inverse_depth_[pixel]) return;
    inverse_depth_[pixel] = near;
    image_.pixels[pixel] = colour;
  });
}

// Shadows darken what is there, each pixel once however many bodies throw one on it.
void Raster::shade(const RasterPoint& a, const RasterPoint& b, const RasterPoint& c,
                   double darkness) {
  fill(a, b, c, [&](std::size_t pixel, float near) {
    if (near < inverse_depth_[pixel] || shaded_[pixel] != 0) return;
    shaded_[pixel] = 1;
    image_.pixels[pixel] = blend(image_.pixels[pixel], {0, 0, 0}, darkness);
  });
}

void Raster::line(const RasterPoint& a, const RasterPoint& b, double width, Rgb colour,
                  double bias) {
  // A line is a quadrilateral of its width, in pixels of the fine picture.
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (!(length > 0)) return;
  const double nx = -dy / length * width / 2, ny = dx / length * width / 2;
  const auto beside = [&](const RasterPoint& p, double side) {
    // The bias moves a line nearer, by a share of its inverse depth: edges lie on the faces that
    // they bound.
    return RasterPoint{p.x + side * nx, p.y + side * ny, p.inverse_depth * (1 + bias)};
  };
  triangle(beside(a, 1), beside(a, -1), beside(b, 1), colour);
  triangle(beside(a, -1), beside(b, -1), beside(b, 1), colour);
}

// Supersampling: means over squares of samples × samples pixels, rounded to the nearest.
Image Raster::image(int samples) const {
  assert(samples > 0);
  if (samples == 1) return image_;
  Image out{image_.width / samples, image_.height / samples, {}};
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      int r = 0, g = 0, b = 0;
      for (int i = 0; i < samples * samples; ++i) {
        const Rgb& pixel = image_.at(x * samples + i % samples, y * samples + i / samples);
        r += pixel.r, g += pixel.g, b += pixel.b;
      }
      const auto mean = [n = samples * samples](int sum) {
        return static_cast<std::uint8_t>((sum + n / 2) / n);
      };
      out.pixels.push_back({mean(r), mean(g), mean(b)});
    }
  }
  return out;
}

}  // namespace stig::physics
