// SPDX-License-Identifier: MIT
// The structure that every order of events ends in, and the structures on the way to it.
//
// Once a rule set is proved, whatever can be built from the start is a part of the proved
// structure in its colours. So a structure on the way is a set of its bricks, here a bit each.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lattice/cell_map.h"
#include "verify/stage_model.h"
#include "verify/verify.h"

namespace stig {

/// A set of the target's bricks, 64 a word.
class BrickSet {
 public:
  explicit BrickSet(std::size_t bricks = 0) : words_((bricks + 63) / 64, 0) {}
  bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  std::size_t count() const;
  std::uint64_t hash() const;
  auto operator<=>(const BrickSet&) const = default;

 private:
  std::vector<std::uint64_t> words_;
};

/// The lowest brick that `after` has and `before` has not.
std::uint32_t brick_added(const BrickSet& before, const BrickSet& after, std::size_t bricks);

class TargetStates {
 public:
  /// Of a proved rule set with a single stage. Both arguments must outlive it.
  TargetStates(const RuleSet& rules, const VerifyResult& proof);
  TargetStates(TargetStates&&) noexcept;
  ~TargetStates();

  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Bricks: those of the start first, then in the order of the proof's run.
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
  bool complete(const BrickSet& state) const { return state.count() == bricks(); }
  bool filled(const BrickSet& state, Cell cell) const {
    const std::uint32_t brick = brick_at(cell);
    return brick != kNone && state.has(brick);
  }
  /// The rule by which the brick may be placed now, or nothing.
  std::optional<std::uint32_t> rule_for(const BrickSet& state, std::size_t brick) const;
  /// Bricks that may be placed now, rising.
  std::vector<std::uint32_t> open(const BrickSet& state) const;
  /// As cells with colours, for drawings.
  Structure structure(const BrickSet& state) const;

 private:
  struct Model;
  const RuleSet* rules_;
  std::unique_ptr<Model> model_;
  std::vector<Cell> cells_;
  std::vector<Colour> colours_;
  std::size_t start_ = 0;
  CellMap<std::uint32_t> numbers_{kNone};
  std::int32_t floor_level_ = 0;
  int levels_ = 0;
};

}  // namespace stig
