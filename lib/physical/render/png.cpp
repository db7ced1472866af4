// SPDX-License-Identifier: MIT
// Cairo holds the pixels for writing letters and the PNG, and nothing else: pictures themselves are
// filled in by Raster, whose results depend on no library. The captions' letters are drawn without
// hinting, so that their bytes depend on the font's outlines alone.
#include <cairo.h>

#include <algorithm>
#include <cassert>
#include <memory>

#include "physical/render/scene_picture.h"

namespace stig::physics {

namespace {

constexpr double kLetters = 22, kMargin = 20;  ///< pixels, of a picture of kUsualWidth
constexpr double kUsualWidth = 1200, kSmallestLetters = 10;

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int size) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

// Rows in cairo's surfaces may be longer than the picture.
Surface surface_of(const Image& image) {
  Surface surface{cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height),
                  cairo_surface_destroy};
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) return surface;
  unsigned char* rows = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.height; ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(rows + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < image.width; ++x) {
      const Rgb& p = image.at(x, y);
      row[x] = std::uint32_t{p.r} << 16 | std::uint32_t{p.g} << 8 | p.b;
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void write_caption(cairo_surface_t* surface, const std::string& caption, const Image& image) {
  const double letters = std::max(kLetters * image.width / kUsualWidth, kSmallestLetters);
  const double margin = kMargin * letters / kLetters;
  // An error of the context costs the caption; one of the surface shows when the PNG is written.
  cairo_t* cairo = cairo_create(surface);
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, letters);
  cairo_font_options_t* options = cairo_font_options_create();
  // Hinting and the screen's order of colours would make the bytes depend on the machine.
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
  cairo_set_source_rgb(cairo, 0.12, 0.16, 0.2);
  cairo_move_to(cairo, margin, image.height - margin);
  cairo_show_text(cairo, caption.c_str());
  cairo_destroy(cairo);
}

}  // namespace

std::string png_of(const Image& image, const std::string& caption) {
  assert(image.width > 0 && image.height > 0);
  const Surface surface = surface_of(image);
  if (!caption.empty()) write_caption(surface.get(), caption, image);
  std::string bytes;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  // An empty text is "no picture": the caller reports that.
  return status == CAIRO_STATUS_SUCCESS ? bytes : std::string{};
}

}  // namespace stig::physics
