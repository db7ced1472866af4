// SPDX-License-Identifier: MIT
// Which bricks stand whenever another does: a partial order that every structure on the way obeys.
//
// From a proved rule set it follows site by site. A brick comes after the neighbours that each of
// its rules asks for. And it comes before those that each of its rules forbids: if one of these
// could be put first, the brick never could be, and the proof says that every order of events ends
// in the whole structure. So whatever can stand is *closed*: with a brick it has all that come
// before. A rule that asks for a brick and forbids one that comes before it matches nothing closed
// and never fires, nor does one that asks for what comes after its own brick; without such rules
// more can follow, and so on.
//
// Robots may obey more than the rules ask for. What would stand in the way to a brick has to come
// after it, and robots see to that where they put a brick only when they know that all stand that
// come before it.
#pragma once

#include <vector>

#include "compiler/lanes.h"
#include "compiler/target_states.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// More are not looked at: the sets below would fill the memory.
inline constexpr std::size_t kMostOrderedBricks = 6000;

class Precedence {
 public:
  /// `before`: by brick, some of those that come before it; such that no brick comes before itself.
  explicit Precedence(const std::vector<std::vector<std::uint32_t>>& before);

  std::size_t bricks() const { return below_.size(); }
  /// All that stand whenever the brick does, the brick among them.
  const BrickSet& below(std::size_t brick) const { return below_[brick]; }
  /// All that are missing whenever the brick is, the brick among them.
  const BrickSet& above(std::size_t brick) const { return above_[brick]; }
  /// From now on `first` comes before `then`, which does not come before it.
  void add(std::uint32_t first, std::uint32_t then);
  /// Does all stand that comes before the brick?
  bool all_before(const BrickSet& state, std::uint32_t brick) const;
  /// Every brick after those that come before it.
  std::vector<std::uint32_t> order() const;

 private:
  std::vector<BrickSet> below_, above_;
};

/// The precedence that follows from a proved rule set; the start's bricks come before all others.
Precedence precedence_of(const TargetStates& target);

/// Can the brick be put from there in all structures in which it is due?
bool always_in_reach(const TargetBricks& target, const Precedence& precedence, Lanes& lanes,
                     const Abilities& robot, std::uint32_t brick, ApproachSide side);

/// Makes bricks wait for those that they would be in the way of: as few as will do that each brick
/// can be put from some side as long as it is due. What has no such side is left as it is.
void wait_for_lanes(const TargetBricks& target, const std::vector<ApproachSide>& sides,
                    const Abilities& robot, Lanes& lanes, Precedence& precedence);

}  // namespace stig::compiler
