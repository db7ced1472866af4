// SPDX-License-Identifier: MIT
// The patterns of a genome in all orientations as bit sets: for each neighbour and state, those
// that accept it. Bit r·G + g stands for rule r in orientation g of G, so that the lowest bit
// is the rule that acts under `conflicts: first`.
//
// rules/rule_table.h has the same idea for rule sets of any kind; this one is built in the time in
// which that one allots its memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "search/genome.h"
#include "search/uses.h"

namespace stig::search {

/// What an array of cells holds: 0 empty, 1..15 a colour, and
inline constexpr std::uint8_t kRowFloor = 16;
inline constexpr std::uint8_t kRowOutside = 17;  ///< empty to the eye, never built upon
inline constexpr std::size_t kRows = 18;

class PatternBits {
 public:
  /// Compiles anew; memory is used again. `low` and `high` are the heights that sites have.
  void compile(const Genome& genome, std::int32_t low, std::int32_t high);

  std::size_t words() const { return words_; }
  std::size_t orientations() const { return orientations_; }
  /// Word w of the set of patterns that accept `row` at `neighbour`.
  std::uint64_t accepting(std::size_t neighbour, std::uint8_t row, std::size_t w) const {
    return accept_[(neighbour * kRows + row) * words_ + w];
  }
  /// Those that there are.
  std::uint64_t all(std::size_t w) const { return all_[w]; }
  /// Has some rule a bound of its height?
  bool limited() const { return limited_; }
  /// Of those that allow the height; for patterns that are limited.
  std::uint64_t at_height(std::int32_t z, std::size_t w) const {
    return heights_[static_cast<std::size_t>(z - low_) * words_ + w];
  }
  /// Neighbours that some pattern asks about, those first that exclude the most.
  const std::vector<std::uint8_t>& order() const { return order_; }

 private:
  void accept_all(const Genome& genome);
  void exclude(const Genome& genome, std::size_t rule);
  void limit_heights(const Genome& genome, std::int32_t low, std::int32_t high);
  void sort_neighbours(std::size_t size);

  std::size_t words_ = 0, orientations_ = 1;
  std::int32_t low_ = 0;
  bool limited_ = false;
  std::vector<std::uint64_t> all_;      ///< [word]: a bit for each pattern that there is
  std::vector<std::uint64_t> accept_;   ///< [neighbour][row][word]
  std::vector<std::uint64_t> heights_;  ///< [z - low][word]
  std::array<bool, kMaxNeighbours> asked_{};
  std::vector<std::uint8_t> order_;
};

}  // namespace stig::search
