// SPDX-License-Identifier: MIT
// Why no order of work builds a target, whatever the rules and colours are. Said only where it is
// proved.
#pragma once

#include "assembly/remainder.h"
#include "assembly/run.h"
#include "assembly/stretch.h"
#include "assembly/uses.h"

namespace stig::assembly {

struct AssemblyObstacle {
  enum class Kind : std::uint8_t {
    exhausted,  ///< every order was looked at: each leaves a brick that nobody can put
    apart,      ///< bricks that share no face with the rest, and so are next to no column of it
    remainder,  ///< bricks of which none can be put last (remainder.h)
    stretch,    ///< slices that so few colours do not tell apart (stretch.h)
    runs,       ///< runs of bricks that so few colours do not tell apart (run.h)
    rules,      ///< so few colours leave no rules at all that robots could follow (any_rules.h)
  } kind = Kind::exhausted;
  BrickSet part{0};     ///< apart: those that hang together with the first brick, or the start
  Remainder remainder;  ///< remainder: what is left
  Stretch stretch;
  std::vector<FreeRun> runs;
  int colours = 0;  ///< stretch, runs, rules: how many there are
  /// rules: how many bricks may be the start, and from one, at most, how many structures were
  /// looked at.
  std::size_t starts = 0, structures = 0;
};

/// Are colours what is missing? With more of them it may be possible.
inline bool takes_more_colours(const AssemblyObstacle& obstacle) {
  return obstacle.kind == AssemblyObstacle::Kind::stretch ||
         obstacle.kind == AssemblyObstacle::Kind::runs ||
         obstacle.kind == AssemblyObstacle::Kind::rules;
}

/// What can be said without a search. `colours`: how many there may be.
std::optional<AssemblyObstacle> find_obstacle(const TargetBricks& target, const Builders& builders,
                                              std::optional<std::uint32_t> start, int colours);

}  // namespace stig::assembly
