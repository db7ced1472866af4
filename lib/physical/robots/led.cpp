// SPDX-License-Identifier: MIT
#include "physical/robots/led.h"

#include <algorithm>

#include "sensing/led_code.h"

namespace stig::physics {

namespace {

constexpr std::size_t kOfFace = 4;  ///< LEDs

sensing::LedWord word_of_face(const BlockLeds& leds, std::size_t face) {
  sensing::LedWord out{};
  for (std::size_t i = 0; i < kOfFace; ++i) {
    out[i] = static_cast<std::uint8_t>(leds[face * kOfFace + i]);
  }
  return out;
}

}  // namespace

BlockLeds leds_showing(Led shown) {
  BlockLeds out{};
  out.fill(shown);
  if (static_cast<std::size_t>(shown) < kLedStates) return out;
  const sensing::LedWord word = sensing::word_of(static_cast<int>(shown));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<Led>(word[i % kOfFace]);
  return out;
}

Led shown_by(const BlockLeds& leds) {
  const sensing::LedWord word = word_of_face(leds, 0);
  bool alike = true;
  for (std::size_t face = 1; face < kBlockLeds / kOfFace; ++face) {
    alike = alike && word_of_face(leds, face) == word;
  }
  if (alike) {
    if (const auto kind = sensing::kind_of(word)) return static_cast<Led>(*kind);
  }
  std::array<int, kLedStates> shown{};
  for (const Led led : leds) ++shown[static_cast<std::size_t>(led)];
  return static_cast<Led>(std::max_element(shown.begin(), shown.end()) - shown.begin());
}

Rgb rgb_of(Led led) {
  constexpr std::array<Rgb, kLedStates> kColours = {
      {{176, 180, 186}, {255, 120, 255}, {255, 208, 27}, {74, 255, 27}, {74, 255, 255}}};
  if (static_cast<std::size_t>(led) < kLedStates) return kColours[static_cast<std::size_t>(led)];
  const sensing::LedWord word = sensing::word_of(static_cast<int>(led));
  int r = 0, g = 0, b = 0;
  for (const std::uint8_t letter : word) {
    r += kColours[letter].r;
    g += kColours[letter].g;
    b += kColours[letter].b;
  }
  const auto mean = [](int sum) { return static_cast<std::uint8_t>(sum / 4); };
  return {mean(r), mean(g), mean(b)};
}

}  // namespace stig::physics
