// SPDX-License-Identifier: MIT
// How time grows with size.
#pragma once

#include <utility>
#include <vector>

namespace stig::bench {

/// seconds = factor · size^exponent.
struct Growth {
  double factor = 0, exponent = 0;
};
/// The line through the logarithms of (size, seconds), by least squares; two sizes or more.
Growth growth_of(const std::vector<std::pair<double, double>>& points);

}  // namespace stig::bench
