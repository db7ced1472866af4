// SPDX-License-Identifier: MIT
// Figures of results as SVG: finds as points, a measure's distribution, and how a search went on.
// The same to the byte everywhere; points that are no numbers are left out.
#pragma once

#include <string>
#include <vector>

#include "search/uses.h"

namespace stig::search {

struct PlotPoint {
  double x = 0, y = 0;
  double shade = 0;  ///< from dark blue (the least) to yellow (the most)
};
/// `shade` names what the colours mean; empty: all points have one.
std::string scatter_svg(const std::string& x, const std::string& y, const std::string& shade,
                        std::vector<PlotPoint> points);

/// How many of the values fall into each of up to 40 equal parts of their range.
std::string histogram_svg(const std::string& name, std::vector<double> values);

/// Searches that are compared: each a curve, x rising.
using PlotCurve = std::vector<std::pair<double, double>>;
/// Several: each thin, their mean, and one standard deviation of the sample about it at those x
/// that all of them have.
std::string curves_svg(const std::string& x, const std::string& y,
                       const std::vector<PlotCurve>& curves);

}  // namespace stig::search
