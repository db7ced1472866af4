// SPDX-License-Identifier: MIT
#include "lattice/picture_marks.h"

#include <fmt/format.h>

#include <cmath>

#include "lattice/picture_scene.h"
#include "lattice/rgb.h"

namespace stig::lattice {

namespace {

constexpr TextLook kLegendLook{14, false, {0x1f, 0x29, 0x33}};
constexpr double kSwatch = 9, kBehindItem = 26;
constexpr Rgb kAxisColour{0x8a, 0x93, 0x9f};

}  // namespace

void count_colours(const Structure& structure, ColourCounts& counts) {
  structure.for_each([&](Cell, State state) { ++counts[state]; });
}

// Symbol, name and number of each colour that shows up.
std::vector<LegendItem> legend_items(const ColourCounts& counts, const std::vector<Brick>& bricks,
                                     bool with_counts) {
  std::vector<LegendItem> items;
  for (const auto& [colour, count] : counts) {
    std::string text = symbol_of(bricks, colour);
    if (colour <= bricks.size()) {
      const std::string& name = bricks[colour - 1U].name;
      if (!name.empty() && name != text) text += "  " + name;
    }
    if (with_counts) text += fmt::format("  ×{}", count);
    items.push_back({colour, text, 2 * kSwatch + 8 + text_width(text, kLegendLook) + kBehindItem});
  }
  return items;
}

// Items flow like words of a paragraph and are never split.
double place_legend(const std::vector<LegendItem>& items, double left, double right,
                    std::vector<PagePoint>& places) {
  double x = left, y = 18;
  for (const LegendItem& item : items) {
    if (x > left && x + item.width - kBehindItem > right) {
      x = left;
      y += kLegendRow;
    }
    places.push_back({x, y});
    x += item.width;
  }
  return items.empty() ? 0 : y + 8;
}

void paint_legend(Canvas& canvas, Lattice lattice, const std::vector<LegendItem>& items,
                  const std::vector<PagePoint>& places, double top,
                  const std::vector<Brick>& bricks) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const PagePoint at{places[i].x, places[i].y + top};
    paint_swatch(canvas, lattice, {at.x + kSwatch, at.y - 5}, kSwatch,
                 rgb_of(bricks, items[i].colour));
    canvas.text(items[i].text, {at.x + 2 * kSwatch + 8, at.y}, kLegendLook);
  }
}

void paint_axes(Canvas& canvas, Lattice lattice, const std::array<PagePoint, 3>& steps,
                PagePoint centre) {
  constexpr double kLength = 26;
  const bool cubic = lattice == Lattice::cubic;
  const std::array<const char*, 3> names = {cubic ? "x" : "q", cubic ? "y" : "r", "z"};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // An axis towards the viewer has neither length nor a place for its name.
    if (std::hypot(steps[i].x, steps[i].y) < 0.1) continue;
    const auto at = [&](double length) {
      return PagePoint{centre.x + length * steps[i].x, centre.y + length * steps[i].y};
    };
    canvas.line(centre, at(kLength), kAxisColour, 1.5);
    const PagePoint end = at(kLength + 9);
    canvas.text(names[i], {end.x - text_width(names[i], kCaptionLook) / 2, end.y + 4},
                kCaptionLook);
  }
}

// A smaller font keeps one line, which the layout has reserved.
void write_fitting(Canvas& canvas, const std::string& text, PagePoint at, TextLook look,
                   double room) {
  const double width = text_width(text, look);
  if (width > room) look.size *= room / width;
  canvas.text(text, at, look);
}

}  // namespace stig::lattice
