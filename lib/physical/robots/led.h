// SPDX-License-Identifier: MIT
// The colours that a block's LEDs take (Allwright et al. 2017): one for each quadrant of
// the UV plane, or none.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/rgb.h"
#include "physical/robots/uses.h"

namespace stig::physics {

enum class Led : std::uint8_t { off, q1, q2, q3, q4 };

inline constexpr std::array<std::string_view, 5> kLedNames = {"off", "Q1", "Q2", "Q3", "Q4"};

constexpr std::string_view to_string(Led led) { return kLedNames[static_cast<std::size_t>(led)]; }

/// The LED state named "Q1" to "Q4" or "off"; nothing for any other word.
constexpr std::optional<Led> led_of(std::string_view name) {
  for (std::size_t i = 0; i < kLedNames.size(); ++i) {
    if (kLedNames[i] == name) return static_cast<Led>(i);
  }
  return std::nullopt;
}

/// As the paper's simulator shows it; of one that is off: the grey of its housing.
constexpr Rgb rgb_of(Led led) {
  constexpr std::array<Rgb, 5> kColours = {
      {{176, 180, 186}, {255, 120, 255}, {255, 208, 27}, {74, 255, 27}, {74, 255, 255}}};
  return kColours[static_cast<std::size_t>(led)];
}

}  // namespace stig::physics
