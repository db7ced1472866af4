// SPDX-License-Identifier: MIT
// What a block shows, by name: nothing, one of the four colours of its LEDs, or, from Q5 on, a code
// word of them (sensing/led_code.h).
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace stig {

/// Kinds of brick that blocks can show: as many as rules can tell apart.
inline constexpr int kMostKinds = 62;

namespace led_name_detail {
/// "Q1", "Q2" and so on, three characters each.
inline constexpr auto kText = [] {
  std::array<char, 3 * (kMostKinds + 1)> out{};
  for (std::size_t kind = 1; kind <= kMostKinds; ++kind) {
    out[3 * kind] = 'Q';
    out[3 * kind + 1] = static_cast<char>('0' + (kind < 10 ? kind : kind / 10));
    out[3 * kind + 2] = static_cast<char>('0' + kind % 10);
  }
  return out;
}();
}  // namespace led_name_detail

/// By kind; 0: "off".
inline constexpr auto kLedNames = [] {
  std::array<std::string_view, kMostKinds + 1> out{"off"};
  for (std::size_t kind = 1; kind <= kMostKinds; ++kind) {
    out[kind] = std::string_view(led_name_detail::kText.data() + 3 * kind, kind < 10 ? 2 : 3);
  }
  return out;
}();

/// The kind of this name, 0 for "off"; nothing for any other word.
constexpr std::optional<int> kind_named(std::string_view name) {
  for (std::size_t kind = 0; kind < kLedNames.size(); ++kind) {
    if (kLedNames[kind] == name) return static_cast<int>(kind);
  }
  return std::nullopt;
}

}  // namespace stig
