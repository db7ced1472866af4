// SPDX-License-Identifier: MIT
// Several robots at one structure: does what is proved of one robot hold for any number?
//
// Robots know nothing of each other. Each comes to a column when it likes, decides by what it
// sees then, and may put its block down much later, when others have put theirs. So a decision
// may be old. What others do in the meantime must neither make it wrong nor bar its way:
//
//     lasting    a brick that was decided on is, whatever others have put since, still wanted by
//                a rule and within reach from its side, unless its site is filled: the robot sees
//                that, and takes its block to another site, in another colour
//     way on     in every structure that robots so come to, one that looks anew finds something
//                to do, and it is right; only the whole structure asks for nothing
//     way out    no brick is put behind a robot into the lane by which it came and leaves
//
// Where each robot has sides of its own, there is one a side at most: then what a side's robot puts
// meets what robots of other sides have decided, and where they stand, and nothing of its own.
//
// Each is a matter of two robots, as one placement and what another has decided meet, and is
// checked for all pairs of decisions that can be pending in a structure: those made there, and
// those made before that are not carried out yet. A pair may be counted that no two robots ever
// hold at a time; so what passes holds, and what fails may be spared by luck.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/decision.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// A brick to be put from a side.
struct Work {
  std::uint32_t brick = 0;
  ApproachSide side{};
  auto operator<=>(const Work&) const = default;
};

/// The gravest first.
enum class ConflictKind : std::uint8_t {
  stuck,      ///< nothing is left to be done, and bricks are missing
  misled,     ///< what is seen asks for what is wrong there
  walled_in,  ///< another's brick stands in the way out
  outdated,   ///< no rule wants the brick any more that was decided on
  barred,     ///< it is out of reach by now
  unwalked,   ///< they come to a structure that the policy knows nothing of
};
std::string_view to_string(ConflictKind kind);  ///< "outdated"

struct Conflict {
  ConflictKind kind{};
  std::uint32_t state = 0;  ///< the structure before `placed` (stuck, misled: the structure itself)
  /// What one robot puts there (stuck, misled: put last; none at the start).
  std::optional<Work> placed;
  std::uint32_t decided_in = 0;  ///< the structure that showed when that was decided
  /// outdated, barred: what another had decided; misled: what it decides.
  std::optional<Work> other;
  std::uint32_t other_decided_in = 0;
  ReachResult reach;           ///< barred: why
  std::optional<Cell> column;  ///< walled_in, misled: foot of the column before which one stands
  ApproachSide stands_at{};    ///< and the side
};

struct Concurrency {
  /// The first of each kind, the gravest kind first; none: any number of robots may work at once.
  std::vector<Conflict> conflicts;
  std::size_t structures = 0;  ///< that several robots can come to
  std::size_t pairs = 0;       ///< of pending decisions
  /// From three or four sides: a robot may stand across another's way out, and so on, perhaps in a
  /// circle. That they never wait for each other for ever is not proved then.
  bool ways_cross = false;
  /// There are conflicts, but none as long as no two robots work from the same side.
  bool one_a_side = false;
};

/// How many robots a check is about.
enum class Crowd : std::uint8_t { one_a_side, any };

/// Checks a complete policy and its tree; for one robot a side, where any number is too many.
Concurrency check_concurrency(const TargetStates& target, const Abilities& robot,
                              const Policy& policy, const DecisionNode& decision);

}  // namespace stig::compiler
