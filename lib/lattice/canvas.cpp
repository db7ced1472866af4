// SPDX-License-Identifier: MIT
// The thin layer over cairo. Everything that makes cairo's output depend on more than its
// input is switched off here: hinting, metrics of a target, and identifiers that count
// through the whole program. All other code draws in units of the page.
#include "lattice/canvas.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <string_view>

namespace stig::lattice {

namespace {

constexpr const char* kFont = "DejaVu Sans";

/// Cairo's streams hand out parts of a file as they come, which a string collects.
cairo_status_t append(void* to, const unsigned char* bytes, unsigned int size) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), size);
  return CAIRO_STATUS_SUCCESS;
}

void set_colour(cairo_t* cairo, Rgb rgb, double opacity = 1) {
  if (opacity < 1) {
    cairo_set_source_rgba(cairo, rgb.r / 255.0, rgb.g / 255.0, rgb.b / 255.0, opacity);
  } else {
    cairo_set_source_rgb(cairo, rgb.r / 255.0, rgb.g / 255.0, rgb.b / 255.0);
  }
}

// Cairo numbers the parts of an .svg through all pages a program ever draws; here
// they are numbered anew, so that the same page has the same bytes.
std::string renumbered(const std::string& svg) {
  constexpr std::string_view kId = "surface";
  std::map<std::string, std::size_t> numbers;
  std::string out;
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t id = std::min(svg.find(kId, at), svg.size());
    const std::size_t begin = std::min(id + kId.size(), svg.size());
    const std::size_t end = std::min(svg.find_first_not_of("0123456789", begin), svg.size());
    out.append(svg, at, begin - at);
    if (end > begin) {
      const auto number = numbers.emplace(svg.substr(begin, end - begin), numbers.size()).first;
      out += std::to_string(number->second);
    }
    at = end;
  }
  return out;
}

// Hinting would make widths depend on the target.
void set_font(cairo_t* cairo, const TextLook& look) {
  cairo_select_font_face(cairo, kFont, CAIRO_FONT_SLANT_NORMAL,
                         look.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, look.size);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo, options);
  cairo_font_options_destroy(options);
}

}  // namespace

struct Canvas::Page {
  PictureFormat format;
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;

  Page(PictureFormat kind, const PageSize& size) : format(kind) {
    surface = kind == PictureFormat::png
                  ? cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)
                  : cairo_svg_surface_create_for_stream(append, &bytes, size.units_wide(),
                                                        size.units_high());
    cairo = cairo_create(surface);
    if (kind == PictureFormat::png) cairo_scale(cairo, size.density, size.density);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    set_colour(cairo, {255, 255, 255});
    cairo_paint(cairo);
  }
  ~Page() { close(); }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  // In this order: a context holds a reference to its surface. Called twice at most, from
  // finish() and the destructor.
  void close() {
    if (cairo != nullptr) cairo_destroy(cairo);
    if (surface != nullptr) cairo_surface_destroy(surface);
    cairo = nullptr;
    surface = nullptr;
  }
};

/// Widths are needed to lay out a page before there is one, hence the one-pixel surface.
double text_width(const std::string& text, const TextLook& look) {
  cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
  cairo_t* cairo = cairo_create(surface);
  set_font(cairo, look);
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo, text.c_str(), &extents);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return extents.x_advance;
}

Canvas::Canvas(PictureFormat format, int width, int height)
    : Canvas(format, PageSize{kDensity * width, kDensity * height, kDensity}) {}

Canvas::Canvas(PictureFormat format, const PageSize& size)
    : page_(std::make_unique<Page>(format, size)) {}

Canvas::~Canvas() = default;

void Canvas::polygon(const PagePoint* corners, std::size_t count, Rgb fill, Rgb edge,
                     double edge_width, double opacity) {
  assert(page_->cairo != nullptr);
  cairo_t* cairo = page_->cairo;
  cairo_new_path(cairo);
  for (std::size_t i = 0; i < count; ++i) cairo_line_to(cairo, corners[i].x, corners[i].y);
  cairo_close_path(cairo);
  set_colour(cairo, fill, opacity);
  cairo_fill_preserve(cairo);
  if (edge_width > 0) {
    set_colour(cairo, edge, opacity);
    cairo_set_line_width(cairo, edge_width);
    cairo_stroke(cairo);
  }
}

void Canvas::line(PagePoint from, PagePoint to, Rgb colour, double width) {
  cairo_t* cairo = page_->cairo;
  // A path that was begun before is discarded, so that drawing functions do not depend on
  // each other.
  cairo_new_path(cairo);
  cairo_move_to(cairo, from.x, from.y);
  cairo_line_to(cairo, to.x, to.y);
  set_colour(cairo, colour);
  cairo_set_line_width(cairo, width);
  cairo_stroke(cairo);
}

void Canvas::text(const std::string& text, PagePoint at, const TextLook& look) {
  set_font(page_->cairo, look);
  set_colour(page_->cairo, look.colour);
  cairo_move_to(page_->cairo, at.x, at.y);
  cairo_show_text(page_->cairo, text.c_str());
}

void Canvas::begin_group() { cairo_push_group(page_->cairo); }

void Canvas::end_group(double opacity) {
  assert(opacity >= 0 && opacity <= 1);
  cairo_pop_group_to_source(page_->cairo);
  cairo_paint_with_alpha(page_->cairo, opacity);
}

std::string Canvas::finish() {
  cairo_status_t status = cairo_status(page_->cairo);
  if (page_->format == PictureFormat::png) {
    if (status == CAIRO_STATUS_SUCCESS) {
      status = cairo_surface_write_to_png_stream(page_->surface, append, &page_->bytes);
    }
  } else {
    // An .svg is complete only when its surface is finished; a .png is written from the
    // surface as it stands.
    cairo_surface_finish(page_->surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(page_->surface);
    page_->bytes = renumbered(page_->bytes);
  }
  page_->close();
  return status == CAIRO_STATUS_SUCCESS ? std::move(page_->bytes) : std::string{};
}

}  // namespace stig::lattice
