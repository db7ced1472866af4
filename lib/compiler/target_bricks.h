// SPDX-License-Identifier: MIT
// The structure that is to be built, and parts of it, whatever the rules are.
//
// Whatever stands on the way is a set of the target's bricks, here a bit each.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/cell_map.h"
#include "rules/rule_set.h"

namespace stig {

/// A set of the target's bricks, 64 a word.
class BrickSet {
 public:
  explicit BrickSet(std::size_t bricks = 0) : words_((bricks + 63) / 64, 0) {}
  bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  void remove(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
  /// All that the other has too. Both are of one target, here and below.
  void add(const BrickSet& others);
  /// Has it all that the other has?
  bool contains(const BrickSet& other) const;
  /// Is there a brick that both have?
  bool meets(const BrickSet& other) const;
  std::size_t count() const;
  std::uint64_t hash() const;
  auto operator<=>(const BrickSet&) const = default;

 private:
  std::vector<std::uint64_t> words_;
};

/// The lowest brick that `after` has and `before` has not.
std::uint32_t brick_added(const BrickSet& before, const BrickSet& after, std::size_t bricks);

class TargetBricks {
 public:
  /// Not empty. The first `start` of them are there from the beginning.
  TargetBricks(const std::vector<PlacedBrick>& bricks, std::size_t start);

  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  std::size_t bricks() const { return cells_.size(); }
  std::size_t start_bricks() const { return start_; }
  Cell cell(std::size_t brick) const { return cells_[brick]; }
  Colour colour(std::size_t brick) const { return colours_[brick]; }
  /// The brick of a cell, or kNone.
  std::uint32_t brick_at(Cell cell) const { return numbers_.at(cell); }
  /// Lowest level of the target, which stands on the floor.
  std::int32_t floor_level() const { return floor_level_; }
  int levels() const { return levels_; }

  BrickSet start() const;
  BrickSet whole() const;
  bool complete(const BrickSet& state) const { return state.count() == bricks(); }
  /// The bricks that these are not.
  BrickSet others(const BrickSet& set) const;
  bool filled(const BrickSet& state, Cell cell) const {
    const std::uint32_t brick = brick_at(cell);
    return brick != kNone && state.has(brick);
  }

 private:
  std::vector<Cell> cells_;
  std::vector<Colour> colours_;
  std::size_t start_ = 0;
  CellMap<std::uint32_t> numbers_{kNone};
  std::int32_t floor_level_ = 0;
  int levels_ = 0;
};

}  // namespace stig
