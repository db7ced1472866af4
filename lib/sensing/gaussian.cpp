// SPDX-License-Identifier: MIT
#include "sensing/gaussian.h"

#include <cmath>
#include <numbers>

namespace stig::sensing {

double gaussian(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return radius * std::cos(2 * std::numbers::pi * random.unit());
}

}  // namespace stig::sensing
