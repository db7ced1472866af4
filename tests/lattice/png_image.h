// SPDX-License-Identifier: MIT
// Pictures as cairo reads them back.
#pragma once

#include <string>
#include <vector>

#include "lattice/rgb.h"
#include "support/uses.h"

namespace stig {

struct PngImage {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;

  struct Spot {
    int count = 0;
    double x = 0, y = 0;  // middle
  };
  Spot find(Rgb colour) const;
  const Rgb& at(int x, int y) const;
};

/// Throws, which fails a test, where it is no PNG.
PngImage png_image(const std::string& png);

}  // namespace stig
