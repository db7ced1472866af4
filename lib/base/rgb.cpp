// SPDX-License-Identifier: MIT
#include "base/rgb.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <cmath>

namespace stig {

namespace {

/// Clamped before rounding: the conversion of values out of range is undefined.
std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(value, 0), 255)));
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Rgb> parse_color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = hex_digit(text[1 + 2 * i]);
    const int low = hex_digit(text[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    channels[i] = static_cast<std::uint8_t>(16 * high + low);
  }
  return Rgb{channels[0], channels[1], channels[2]};
}

std::string to_color(Rgb rgb) { return fmt::format("#{:02x}{:02x}{:02x}", rgb.r, rgb.g, rgb.b); }

/// Blended in sRGB and not in linear light: what pictures need are evenly spaced shades.
Rgb blend(Rgb a, Rgb b, double t) {
  assert(t >= 0 && t <= 1);
  const auto channel = [t](std::uint8_t from, std::uint8_t to) {
    return to_byte(from + t * (to - from));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

double linear_light(std::uint8_t value) {
  const double s = value / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace stig
