// SPDX-License-Identifier: MIT
#include "render_values.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "numbers.h"

namespace stig::cli {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr std::int64_t kFewestPixels = 64, kMostPixels = 4096;  ///< a side

}  // namespace

std::string parse_view(std::string_view text, RenderView& out) {
  out = {};
  if (text == "iso") return {};
  out.orbit = text == "orbit";
  if (out.orbit) return {};
  if (text == "front" || text == "top") {
    out.azimuth = -kRightAngle;
    out.elevation = text == "top" ? kRightAngle : 0;
    return {};
  }
  std::array<double, 3> xyz{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    const bool good = (comma == std::string_view::npos) == (i == 2) &&
                      parse_number(rest.substr(0, comma), xyz[i]).empty();
    if (!good) {
      return fmt::format("'{}' is not one of iso, front, top, orbit, nor a direction like 1,-2,1",
                         text);
    }
    rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
  }
  const auto [x, y, z] = xyz;
  if (x == 0 && y == 0 && z == 0) return "0,0,0 is no direction";
  const bool upright = x == 0 && y == 0;
  // From above, y is up on the picture.
  out.azimuth = upright ? -kRightAngle : std::atan2(y, x);
  out.elevation = std::atan2(z, std::hypot(x, y));
  return {};
}

std::string parse_pixels(std::string_view text, int& width, int& height) {
  const std::size_t x = text.find('x');
  std::int64_t wide = 0, high = 0;
  const bool good = x != std::string_view::npos &&
                    parse_integer(text.substr(0, x), kFewestPixels, kMostPixels, wide).empty() &&
                    parse_integer(text.substr(x + 1), kFewestPixels, kMostPixels, high).empty();
  if (!good) {
    return fmt::format("'{}' is no size like 1200x800, of sides of {} to {} pixels", text,
                       kFewestPixels, kMostPixels);
  }
  width = static_cast<int>(wide);
  height = static_cast<int>(high);
  return {};
}

std::string parse_slice(std::string_view text, Slice& out) {
  const std::size_t axis = std::string_view("xyz").find(text.substr(0, 1));
  const std::size_t dots = text.find("..");
  const bool form = text.size() > 4 && axis < 3 && text[1] == '=';
  if (form && dots != std::string_view::npos) {
    const std::string_view low = text.substr(2, dots - 2), high = text.substr(dots + 2);
    out.axis = static_cast<int>(axis);
    const bool good = (low.empty() || parse_number(low, out.low).empty()) &&
                      (high.empty() || parse_number(high, out.high).empty()) &&
                      !(low.empty() && high.empty());
    if (good && out.low <= out.high) return {};
    if (good) return fmt::format("nothing lies within '{}'", text);
  }
  return fmt::format("'{}' is no part of an axis like z=0..3, x=..2 or y=1..", text);
}

}  // namespace stig::cli
