// SPDX-License-Identifier: MIT
// A page to draw on: the little of cairo that pictures need. x to the right, y down;
// a unit is kDensity pixels of a .png, unless the page is made for a number of pixels.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lattice/picture.h"
#include "lattice/rgb.h"
#include "lattice/uses.h"
#include "lattice/view.h"

namespace stig::lattice {

struct TextLook {
  double size = 14;  ///< units
  bool bold = false;
  Rgb colour{0x1f, 0x29, 0x33};
};

/// Width that a text will have, in units.
double text_width(const std::string& text, const TextLook& look);

/// A page of so many pixels, if it is a .png.
struct PageSize {
  int width = 0, height = 0;  ///< pixels
  double density = 2;         ///< pixels a unit

  double units_wide() const { return width / density; }
  double units_high() const { return height / density; }
};

class Canvas {
 public:
  /// Pixels of an image for each unit: sharp on fine screens and in print.
  static constexpr int kDensity = 2;

  /// A white page, of that size in units.
  Canvas(PictureFormat format, int width, int height);
  Canvas(PictureFormat format, const PageSize& size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Fills the outline; then draws its edge, unless `edge_width` is 0.
  void polygon(const PagePoint* corners, std::size_t count, Rgb fill, Rgb edge, double edge_width,
               double opacity = 1);
  void line(PagePoint from, PagePoint to, Rgb colour, double width);
  /// `at` is the left end of the base line.
  void text(const std::string& text, PagePoint at, const TextLook& look);

  /// What is drawn until end_group appears as one sheet of that opacity.
  void begin_group();
  void end_group(double opacity);

  /// The file's bytes, once; empty when cairo failed.
  std::string finish();

 private:
  struct Page;
  std::unique_ptr<Page> page_;
};

}  // namespace stig::lattice
