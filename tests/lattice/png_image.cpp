// SPDX-License-Identifier: MIT
#include "png_image.h"

#include <cairo.h>

#include <cstring>
#include <stdexcept>

namespace stig {

PngImage::Spot PngImage::find(Rgb colour) const {
  Spot spot;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i] != colour) continue;
    ++spot.count;
    spot.x += static_cast<double>(i % static_cast<std::size_t>(width));
    spot.y += static_cast<double>(i / static_cast<std::size_t>(width));
  }
  spot.x /= spot.count;
  spot.y /= spot.count;
  return spot;
}

const Rgb& PngImage::at(int x, int y) const {
  return pixels.at(static_cast<std::size_t>(y * width + x));
}

PngImage png_image(const std::string& png) {
  struct Source {
    const char* at;
    std::size_t left;
  } source{png.data(), png.size()};
  const auto read = [](void* from, unsigned char* to, unsigned int size) {
    auto& in = *static_cast<Source*>(from);
    if (size > in.left) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(to, in.at, size);
    in.at += size;
    in.left -= size;
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = cairo_image_surface_create_from_png_stream(read, &source);
  if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) throw std::runtime_error("no PNG");
  PngImage out{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* data = cairo_image_surface_get_data(surface);
  for (int y = 0; y < out.height; ++y) {
    const unsigned char* row = data + y * cairo_image_surface_get_stride(surface);
    for (int x = 0; x < out.width; ++x, row += 4) out.pixels.push_back({row[2], row[1], row[0]});
  }
  cairo_surface_destroy(surface);
  return out;
}

}  // namespace stig
