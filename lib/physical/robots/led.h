// SPDX-License-Identifier: MIT
// The colours that a block's LEDs take (Allwright et al. 2017): one for each quadrant of
// the UV plane, or none; and what a whole block shows by them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/led_name.h"
#include "base/rgb.h"
#include "physical/robots/uses.h"
#include "robots/robot_io.h"

namespace stig::physics {

/// Of one LED: off, or one of four colours. Of a block as a whole also more, up to kMostKinds: that
/// each of its faces shows the code word of this kind (sensing/led_code.h).
enum class Led : std::uint8_t { off, q1, q2, q3, q4 };

inline constexpr std::size_t kLedStates = 5;  ///< of one LED

constexpr std::string_view to_string(Led led) { return kLedNames[static_cast<std::size_t>(led)]; }

/// What is named "Q1" to "Q62" or "off"; nothing for any other word.
constexpr std::optional<Led> led_of(std::string_view name) {
  const auto kind = kind_named(name);
  return kind ? std::optional(static_cast<Led>(*kind)) : std::nullopt;
}

/// A block's LEDs, face by face as its radios are numbered, four a face as sensing::LedWord has
/// them.
using BlockLeds = std::array<Led, kBlockLeds>;
/// LEDs by which a block shows this.
BlockLeds leds_showing(Led shown);
/// What LEDs show: the kind whose code word all faces have; otherwise the colour that most of them
/// have, among equals the one with the lowest number, which off has.
Led shown_by(const BlockLeds& leds);

/// As the paper's simulator shows it; of one that is off: the grey of its housing; of a code word:
/// its colours mixed.
Rgb rgb_of(Led led);

}  // namespace stig::physics
