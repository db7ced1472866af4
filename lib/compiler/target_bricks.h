// SPDX-License-Identifier: MIT
// The structure that is to be built, and parts of it, whatever the rules are.
//
// Whatever stands on the way is a set of the target's bricks, here a bit each.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/uses.h"
#include "lattice/cell_map.h"
#include "rules/rule_set.h"

namespace stig::compiler {

/// A set of the target's bricks, 64 a word.
class BrickSet {
 public:
  explicit BrickSet(std::size_t bricks = 0) : words_((bricks + 63) / 64, 0) {}
  bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  void remove(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
  /// All bricks of a target of so many.
  static BrickSet first(std::size_t bricks);
  /// All that the other has too. Both are of one target, here and below.
  void add(const BrickSet& others);
  void remove(const BrickSet& others);
  /// Has it all that the other has?
  bool contains(const BrickSet& other) const;
  /// Has it all that the other has, not counting one brick?
  bool contains_but(const BrickSet& other, std::size_t brick) const;
  /// Is there a brick that both have?
  bool meets(const BrickSet& other) const;
  std::size_t count() const;
  std::uint64_t hash() const;
  bool operator==(const BrickSet&) const = default;
  bool operator<(const BrickSet& other) const { return words_ < other.words_; }

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
  /// Bricks of one x, or of one y, rising; at any level.
  const std::vector<std::uint32_t>& with_x(std::int32_t x) const {
    return line(with_x_, x - low_x_);
  }
  const std::vector<std::uint32_t>& with_y(std::int32_t y) const {
    return line(with_y_, y - low_y_);
  }
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
  using Lines = std::vector<std::vector<std::uint32_t>>;
  static const std::vector<std::uint32_t>& line(const Lines& lines, std::int32_t at) {
    static const std::vector<std::uint32_t> none;
    const bool inside = at >= 0 && static_cast<std::size_t>(at) < lines.size();
    return inside ? lines[static_cast<std::size_t>(at)] : none;
  }
  void sort_into_lines();

  std::vector<Cell> cells_;
  std::vector<Colour> colours_;
  std::size_t start_ = 0;
  CellMap<std::uint32_t> numbers_{kNone};
  Lines with_x_, with_y_;
  std::int32_t low_x_ = 0, low_y_ = 0;
  std::int32_t floor_level_ = 0;
  int levels_ = 0;
};

}  // namespace stig::compiler
