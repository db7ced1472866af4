// SPDX-License-Identifier: MIT
// What a lattice cell can show to an agent: nothing, a brick of a colour, or
// the floor. States are bytes so that a world is an array of them.
#pragma once

#include <bit>
#include <cstdint>

namespace stig::rules {

/// 0 is empty, 1..kMaxColours a brick of that colour, kFloor the floor.
using State = std::uint8_t;
/// A brick colour, 1..kMaxColours: the k-th entry of the rule set's `bricks`.
using Colour = std::uint8_t;

inline constexpr State kEmpty = 0;
inline constexpr State kFloor = 63;
inline constexpr int kMaxColours = 62;

constexpr bool is_brick(State state) { return state != kEmpty && state != kFloor; }

/// A set of states, one bit each.
class StateSet {
 public:
  constexpr StateSet() = default;
  constexpr explicit StateSet(std::uint64_t bits) : bits_(bits) {}
  static constexpr StateSet of(State state) { return StateSet(std::uint64_t{1} << state); }
  static constexpr StateSet empty_cell() { return of(kEmpty); }
  static constexpr StateSet floor() { return of(kFloor); }
  /// Every brick of a set with `colours` colours (`#` in a drawing).
  static constexpr StateSet bricks(int colours) {
    return StateSet(((std::uint64_t{1} << colours) - 1) << 1);
  }
  /// Everything: empty, any brick, floor (`?` in a drawing). The same bits
  /// whatever the number of colours.
  static constexpr StateSet anything() { return StateSet(~std::uint64_t{0}); }

  constexpr std::uint64_t bits() const { return bits_; }
  constexpr bool contains(State state) const { return (bits_ >> state) & 1U; }
  constexpr bool none() const { return bits_ == 0; }
  constexpr int count() const { return std::popcount(bits_); }
  constexpr bool is_single() const { return std::has_single_bit(bits_); }
  /// The lowest state in the set; the set must not be empty.
  constexpr State first() const { return static_cast<State>(std::countr_zero(bits_)); }
  constexpr bool subset_of(StateSet other) const { return (bits_ & ~other.bits_) == 0; }

  constexpr StateSet operator|(StateSet o) const { return StateSet(bits_ | o.bits_); }
  constexpr StateSet operator&(StateSet o) const { return StateSet(bits_ & o.bits_); }
  constexpr bool operator==(const StateSet&) const = default;

 private:
  std::uint64_t bits_ = 0;
};

}  // namespace stig::rules
