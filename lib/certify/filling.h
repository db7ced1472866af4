// SPDX-License-Identifier: MIT
// Sets of a window's bricks as bits, and as numbers, least bit first.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>

#include "certify/certificate.h"
#include "certify/uses.h"

namespace stig::certify {

inline constexpr std::size_t kBitsPerWord = 64;

inline std::size_t words_for(std::size_t bits) { return (bits + kBitsPerWord - 1) / kBitsPerWord; }
inline bool has(const Filling& filling, std::size_t bit) {
  assert(bit / kBitsPerWord < filling.size());
  return (filling[bit / kBitsPerWord] >> bit % kBitsPerWord & 1U) != 0;
}
inline Filling with(Filling filling, std::size_t bit) {
  assert(bit / kBitsPerWord < filling.size());
  filling[bit / kBitsPerWord] |= std::uint64_t{1} << bit % kBitsPerWord;
  return filling;
}
inline std::size_t count_bricks(const Filling& filling) {
  std::size_t number = 0;
  for (const std::uint64_t word : filling) number += static_cast<std::size_t>(std::popcount(word));
  return number;
}
/// The right length, and no bit past it.
inline bool is_filling_of(std::size_t bits, const Filling& filling) {
  if (filling.size() != words_for(bits)) return false;
  return bits % kBitsPerWord == 0 || filling.back() >> bits % kBitsPerWord == 0;
}
/// As numbers.
inline bool less(const Filling& a, const Filling& b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

}  // namespace stig::certify
