// SPDX-License-Identifier: MIT
// Figures hold what they are given, whatever it is.
#include <doctest/doctest.h>

#include <cmath>

#include "search/plots.h"
#include "search/uses.h"
#include "support/uses.h"

namespace stig {
namespace {

using namespace search;

int count_of(const std::string& text, std::string_view part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a point for each find, and colours from the least to the most") {
  const std::string svg = scatter_svg("a<b", "y", "c", {{0, 0, 1}, {1, -2, 2}, {5, 3, 3}});
  CHECK(count_of(svg, "<circle") == 3);
  CHECK(svg.find("a&lt;b") != std::string::npos);
  CHECK(svg.find("#440154") != std::string::npos);
  CHECK(svg.find("#fde725") != std::string::npos);
  CHECK(scatter_svg("x", "y", "", {{1, 1, 0}}).find("<circle") != std::string::npos);
}

TEST_CASE("values that are no numbers are left out, and nothing is drawn as nothing") {
  CHECK(count_of(scatter_svg("x", "y", "", {{NAN, 0, 0}, {1, 2, 0}}), "<circle") == 1);
  CHECK(histogram_svg("x", {INFINITY}).find("nothing to show") != std::string::npos);
  CHECK(curves_svg("x", "y", {}).find("nothing to show") != std::string::npos);
  CHECK(curves_svg("x", "y", {{{0, NAN}}}).find("nothing to show") != std::string::npos);
}

TEST_CASE("bars count values, equal ones in one bar") {
  CHECK(count_of(histogram_svg("x", {1, 1, 1}), "class=\"bar\"") == 1);
  CHECK(count_of(histogram_svg("x", {0, 10, 10}), "class=\"bar\"") == 2);
}

TEST_CASE("one curve is drawn as itself, several have their mean and a band") {
  const PlotCurve low = {{0, 0}, {1, 1}}, high = {{0, 2}, {1, 3}};
  const std::string one = curves_svg("x", "y", {low});
  CHECK(count_of(one, "class=\"mean\"") == 1);
  CHECK(count_of(one, "class=\"band\"") == 0);
  const std::string two = curves_svg("x", "y", {low, high});
  CHECK(count_of(two, "class=\"run\"") == 2);
  CHECK(count_of(two, "class=\"mean\"") == 1);
  CHECK(count_of(two, "class=\"band\"") == 1);
  // Searches of different batches share no x.
  CHECK(count_of(curves_svg("x", "y", {{{0, 0}}, {{1, 1}}}), "class=\"band\"") == 0);
}

}  // namespace stig
