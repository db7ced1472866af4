// SPDX-License-Identifier: MIT
#include "growth.h"

#include <algorithm>
#include <cmath>

namespace stig::bench {

Growth growth_of(const std::vector<std::pair<double, double>>& points) {
  constexpr double kLeast = 1e-3;  // s: below, the clock's own steps show
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [size, seconds] : points) {
    const double a = std::log(size), b = std::log(std::max(seconds, kLeast));
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const auto n = static_cast<double>(points.size());
  const double exponent = (n * xy - x * y) / (n * xx - x * x);
  return {std::exp((y - exponent * x) / n), exponent};
}

}  // namespace stig::bench
