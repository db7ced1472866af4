// SPDX-License-Identifier: MIT
// What stands beside the drawing on a page: title and caption, the legend, the axes. Lengths are in
// units of the canvas.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lattice/canvas.h"
#include "lattice/uses.h"

namespace stig::lattice {

inline constexpr TextLook kTitleLook{21, true, {0x1f, 0x29, 0x33}};
inline constexpr TextLook kCaptionLook{13, false, {0x5b, 0x64, 0x70}};
inline constexpr double kLegendRow = 26;  ///< height
inline constexpr double kAxes = 84;       ///< width and height of their place

using ColourCounts = std::map<Colour, std::size_t>;
void count_colours(const Structure& structure, ColourCounts& counts);

/// A brick in the legend: swatch, symbol and name.
struct LegendItem {
  Colour colour = 0;
  std::string text;
  double width = 0;  ///< swatch and gap to the next included
};
std::vector<LegendItem> legend_items(const ColourCounts& counts, const std::vector<Brick>& bricks,
                                     bool with_counts);
/// Lays the legend in rows between two margins; returns its height, and the left end of each item's
/// base line, down from the legend's top.
double place_legend(const std::vector<LegendItem>& items, double left, double right,
                    std::vector<PagePoint>& places);
void paint_legend(Canvas& canvas, Lattice lattice, const std::vector<LegendItem>& items,
                  const std::vector<PagePoint>& places, double top,
                  const std::vector<Brick>& bricks);

/// The lattice's three axes, a step along each on the page, from `centre`.
void paint_axes(Canvas& canvas, Lattice lattice, const std::array<PagePoint, 3>& steps,
                PagePoint centre);

/// Text that is too long for the room is written smaller.
void write_fitting(Canvas& canvas, const std::string& text, PagePoint at, TextLook look,
                   double room);

}  // namespace stig::lattice
