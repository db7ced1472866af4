// SPDX-License-Identifier: MIT
#include "sensing/led_code.h"

#include <cassert>

#include "base/led_name.h"

namespace stig::sensing {

namespace {

constexpr int kPlain = 4, kSingle = 16;  ///< sizes of the codes of distance 4 and 3

/// The field of four elements 0, 1, w and w + 1 as 0 to 3; to add is exclusive or.
constexpr std::array<std::array<std::uint8_t, 4>, 4> kTimes = {
    {{0, 0, 0, 0}, {0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}}};

}  // namespace

int code_size(int kinds) {
  assert(kinds >= 1 && kinds <= kMostKinds);
  return kinds <= kPlain ? kPlain : kinds <= kSingle ? kSingle : kMostKinds;
}

int code_distance(int kinds) {
  const int size = code_size(kinds);
  return size == kPlain ? 4 : size == kSingle ? 3 : 2;
}

// Of four LEDs any but distance - 1 tell words apart, and one more may be missed.
int leds_needed(int kinds) {
  const int distance = code_distance(kinds);
  return distance == 4 ? 1 : 4 - (distance - 1) + 1;
}

LedWord word_of(int kind) {
  assert(kind >= 1 && kind <= kMostKinds);
  const auto number = static_cast<unsigned>(kind - 1);
  const unsigned a = number % 4, b = number / 4 % 4, c = number / 16;
  LedWord out{};
  for (std::size_t x = 0; x < out.size(); ++x) {
    const unsigned square = kTimes[x][x];
    out[x] = static_cast<std::uint8_t>(1 + (a ^ kTimes[b][x] ^ kTimes[c][square]));
  }
  return out;
}

std::optional<int> kind_of(const LedWord& word) {
  for (int kind = 1; kind <= kMostKinds; ++kind) {
    if (word_of(kind) == word) return kind;
  }
  return std::nullopt;
}

}  // namespace stig::sensing
