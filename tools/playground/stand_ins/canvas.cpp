// SPDX-License-Identifier: MIT
// Pages as SVG texts, in place of lib/lattice/canvas.cpp: what is drawn, and where, is decided
// above it by the same code. Lines of text are given the length that the layout took them for,
// whatever font a reader has.
#include "lattice/canvas.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <iterator>
#include <string_view>

namespace stig::lattice {

namespace {

/// Widths of characters in parts of the font's size, about as DejaVu Sans has them.
constexpr std::string_view kNarrow = " !'(),./:;I[]fijlrt|";
constexpr std::string_view kWide = "%@MWmw";
constexpr double kNarrowWidth = 0.36, kUsualWidth = 0.62, kWideWidth = 0.94, kBold = 1.1;

double width_of(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x80 && byte < 0xC0) return 0;  // of a character that has begun before
  if (kNarrow.find(c) != std::string_view::npos) return kNarrowWidth;
  return kWide.find(c) != std::string_view::npos ? kWideWidth : kUsualWidth;
}

std::string hex(Rgb rgb) { return fmt::format("#{:02x}{:02x}{:02x}", rgb.r, rgb.g, rgb.b); }

/// To a thousandth of a unit, and never "-0".
std::string number(double value) {
  return fmt::format("{}", std::round(value * 1000) / 1000 + 0.0);
}

std::string attribute_if_less(const char* name, double value) {
  return value < 1 ? fmt::format(" {}=\"{}\"", name, number(value)) : std::string();
}

/// XML takes no control characters, whichever way they are written.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F) {
      out += c;
    }
  }
  return out;
}

}  // namespace

struct Canvas::Page {
  std::string head, body;
  /// Where groups begin that are not ended.
  std::vector<std::size_t> groups;
};

double text_width(const std::string& text, const TextLook& look) {
  double width = 0;
  for (const char c : text) width += width_of(c);
  return width * look.size * (look.bold ? kBold : 1);
}

Canvas::Canvas(PictureFormat format, int width, int height)
    : Canvas(format, PageSize{kDensity * width, kDensity * height, kDensity}) {}

Canvas::Canvas(PictureFormat format, const PageSize& size) : page_(std::make_unique<Page>()) {
  assert(format == PictureFormat::svg);
  const std::string wide = number(size.units_wide()), high = number(size.units_high());
  page_->head = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" stroke-linejoin=\"round\" stroke-linecap=\"round\" "
      "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      wide, high);
}

Canvas::~Canvas() = default;

void Canvas::polygon(const PagePoint* corners, std::size_t count, Rgb fill, Rgb edge,
                     double edge_width, double opacity) {
  std::string points;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) points += ' ';
    points += number(corners[i].x) + "," + number(corners[i].y);
  }
  const std::string stroke =
      edge_width > 0 ? fmt::format(" stroke=\"{}\" stroke-width=\"{}\"{}", hex(edge),
                                   number(edge_width), attribute_if_less("stroke-opacity", opacity))
                     : std::string();
  fmt::format_to(std::back_inserter(page_->body), "<polygon points=\"{}\" fill=\"{}\"{}{}/>\n",
                 points, hex(fill), attribute_if_less("fill-opacity", opacity), stroke);
}

void Canvas::line(PagePoint from, PagePoint to, Rgb colour, double width) {
  fmt::format_to(std::back_inserter(page_->body),
                 "<path d=\"M{} {}L{} {}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", number(from.x),
                 number(from.y), number(to.x), number(to.y), hex(colour), number(width));
}

void Canvas::text(const std::string& text, PagePoint at, const TextLook& look) {
  if (text.empty()) return;
  fmt::format_to(std::back_inserter(page_->body),
                 "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{} fill=\"{}\" textLength=\"{}\" "
                 "lengthAdjust=\"spacingAndGlyphs\" xml:space=\"preserve\">{}</text>\n",
                 number(at.x), number(at.y), number(look.size),
                 look.bold ? " font-weight=\"bold\"" : "", hex(look.colour),
                 number(text_width(text, look)), escaped(text));
}

void Canvas::begin_group() { page_->groups.push_back(page_->body.size()); }

void Canvas::end_group(double opacity) {
  assert(!page_->groups.empty());
  page_->body.insert(page_->groups.back(), fmt::format("<g opacity=\"{}\">\n", number(opacity)));
  page_->groups.pop_back();
  page_->body += "</g>\n";
}

std::string Canvas::finish() { return page_->head + page_->body + "</svg>\n"; }

}  // namespace stig::lattice
