// SPDX-License-Identifier: MIT
// An order in which robots that know everything could put the bricks of a target.
//
// The finished structure is taken apart: a brick goes when a robot could have put it there last,
// next to a column that it can stand before, within reach. The reverse is an order of work. Where
// several bricks could go, a *liking* says which goes first; where none can, the last choice is
// undone. Sets of bricks that lead nowhere are remembered.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assembly/last_brick.h"
#include "assembly/uses.h"

namespace stig::assembly {

/// Which bricks come late: those of the highest score, a sum of coordinates so weighted and of
/// chance.
struct Liking {
  int x = 0, y = 0, z = 0;
  /// The distance from the middle is what counts of a coordinate.
  bool middle_x = false, middle_y = false;
  /// Some rows in the middle come first, then one row after the other beside them: a row that
  /// stands by itself tells its bricks apart by colours alone, several together count in digits.
  enum class Spine : std::uint8_t { none, along_x, along_y } spine = Spine::none;
  int spine_rows = 2;
  /// The spine grows towards robots at its ends and not, zigzag, before those at its sides.
  bool from_ends = false;
  /// Rows beside a spine grow from their low ends, wherever the spine begins.
  bool swept = false;
  /// Work goes along paths: from the column of the one, a cell, and not through that of the other,
  /// which is the last. A closed chain is so built in one arm, round to where it began.
  struct Round {
    Cell first, last;
  };
  std::optional<Round> round;
  /// Of a plate so many rows come first, which count (counted.h); 0: no such thing.
  int counting_rows = 0;
  int chance = 0;  ///< a number below this is added
  std::uint64_t seed = 0;
  bool in_chains = false;  ///< what is next to the last brick that went goes first
};

/// The rows of a spine, as coordinates across it.
struct SpineRows {
  int first = 0, last = 0;
  /// How far a row is from them, signed; 0 for one of them.
  int beside(int at) const { return at < first ? at - first : at > last ? at - last : 0; }
};
/// In the middle of the target; the liking has a spine.
SpineRows spine_rows(const TargetBricks& target, const Liking& liking);

struct Sequence {
  std::vector<std::uint32_t> bricks;  ///< the start first
  std::vector<ApproachSide> sides;    ///< from where each can be put; the start's means nothing
};

/// Begins with `start` or, where none is given, with a brick on the floor. Nothing when there is
/// no such order or, with `most` at 0, when none was found by looking at so many bricks; what was
/// looked at is taken off.
std::optional<Sequence> find_sequence(const TargetBricks& target, const Builders& builders,
                                      std::optional<std::uint32_t> start, const Liking& liking,
                                      std::uint64_t& most);

}  // namespace stig::assembly
