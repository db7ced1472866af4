// SPDX-License-Identifier: MIT
// Round numbers for grids and axes.
#pragma once

#include <cassert>

namespace stig {

/// The first of `least` times 1, 2, 5, 10, 20, 50 … of which at most `most` reach over `span`.
inline double round_step(double span, double most, double least = 1) {
  assert(most > 0 && least > 0);
  double step = least;
  for (int i = 0; step * most < span && i < 1000; ++i) step *= i % 3 == 1 ? 2.5 : 2;
  return step;
}

}  // namespace stig
