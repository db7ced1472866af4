// SPDX-License-Identifier: MIT
// Brick colours as numbers, for files and pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rules/rule_set.h"

namespace stig {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  auto operator<=>(const Rgb&) const = default;
};

/// "#rrggbb", either case; nothing for anything else.
std::optional<Rgb> parse_color(std::string_view text);
/// "#rrggbb" in lower case.
std::string to_color(Rgb rgb);

/// The colour of brick `colour`; one of a built-in palette, distinct for small
/// numbers, when `bricks` has no such brick or its colour is not "#rrggbb".
Rgb rgb_of(const std::vector<Brick>& bricks, Colour colour);

/// (1 - t)·a + t·b, rounded, for t in [0, 1].
Rgb blend(Rgb a, Rgb b, double t);

/// One value of sRGB (0..255) as linear light in [0, 1] (IEC 61966-2-1).
double linear_light(std::uint8_t value);

/// Bricks 1..count of the built-in palette, with symbols and names "1", "2", ….
std::vector<Brick> numbered_bricks(int count);

/// The symbol of a colour; its number when `bricks` has no such brick.
std::string symbol_of(const std::vector<Brick>& bricks, Colour colour);

}  // namespace stig
