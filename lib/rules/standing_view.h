// SPDX-License-Identifier: MIT
// A view where it stands: the states around a site of an array, which an engine keeps up to date
// instead of gathering a View for every question that it has.
//
// The array holds codes: 0 for an empty cell, a colour's own number for a brick of it, and
// RuleTable::floor_code() for the floor. Each site has a word that says which of its neighbours are
// not empty, and a hash that changes by one term when one of them does.
#pragma once

#include <array>
#include <cstdint>

#include "base/hash.h"
#include "rules/neighbourhood.h"

namespace stig::rules {

/// A cell of such an array.
struct CodedCell {
  std::uint8_t code = 0;
  std::uint8_t marks = 0;  ///< the owner's
};

struct StandingView {
  const CodedCell* site;
  const std::int32_t* step;    ///< from the site to each neighbour, by index
  std::uint32_t occupied = 0;  ///< bit i: neighbour i is not empty
  std::uint64_t hash = 0;      ///< exclusive or of ViewHash's words

  std::size_t code(std::size_t neighbour) const { return site[step[neighbour]].code; }
};

/// Random words by neighbour and state; a view's hash is their exclusive or. Exclusive or
/// makes the hash independent of the order of neighbours, and each table entry is a
/// compile-time constant.
struct ViewHash {
  std::array<std::array<std::uint64_t, 64>, 32> word{};
  constexpr ViewHash() {
    for (std::size_t i = 0; i < 32; ++i) {
      // Word of the empty state is 0, so only what stands around costs entropy.
      for (std::size_t s = 1; s < 64; ++s) word[i][s] = mix(i * 64 + s + 0x517cc1b727220a95ULL);
    }
  }
  std::uint64_t operator()(const View& view, int size) const {
    std::uint64_t h = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) h ^= word[i][view.at[i]];
    return h;
  }
};
inline constexpr ViewHash kViewHash;

/// What is seen at a glance of a closed site beside a new brick: mostly, that it stays closed.
struct OpeningFilter {
  const std::uint32_t* slots;  ///< by hashes of entries without wildcards; 0: none
  std::uint64_t slot_mask;
  const std::uint8_t* asked;  ///< [neighbour][code]: does another entry ask for it?
  std::size_t codes;

  bool may_open(std::uint64_t hash, std::size_t neighbour, std::size_t code) const {
    return asked[neighbour * codes + code] != 0 || slots[hash & slot_mask] != 0;
  }
};

}  // namespace stig::rules
