// SPDX-License-Identifier: MIT
// 64-bit hashing with fixed results (never std::hash): traces and golden files
// depend on them. Mixing is MurmurHash3's finalizer (Appleby); text is FNV-1a,
// mixed at the end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stig {

constexpr std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  x ^= x >> 33;
  return x;
}
/// Not symmetric: the seed is mixed once more than the value.
constexpr std::uint64_t combine(std::uint64_t seed, std::uint64_t value) {
  return mix(mix(seed + 0x9e3779b97f4a7c15ULL) + value);
}
constexpr std::uint64_t hash_text(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325ULL;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return mix(h);
}
/// 16 hexadecimal digits.
std::string to_hex(std::uint64_t value);

}  // namespace stig
