// SPDX-License-Identifier: MIT
// Colours as numbers: sRGB, eight bits a channel.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stig {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  auto operator<=>(const Rgb&) const = default;
};

/// "#rrggbb", either case; nothing for anything else.
std::optional<Rgb> parse_color(std::string_view text);
/// "#rrggbb" in lower case.
std::string to_color(Rgb rgb);

/// (1 - t)·a + t·b, rounded, for t in [0, 1].
Rgb blend(Rgb a, Rgb b, double t);

/// One value of sRGB (0..255) as linear light in [0, 1] (IEC 61966-2-1).
double linear_light(std::uint8_t value);

}  // namespace stig
