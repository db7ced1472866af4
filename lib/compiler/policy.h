// SPDX-License-Identifier: MIT
// Which placement to make when a column shows what: a policy under which every order of work
// completes the structure.
//
// A *situation* is a structure on the way, a side, and the foremost column of a row seen from
// there: what a robot with a block has before it. It shows an observation (sight.h) and offers
// placements: bricks that the rules allow now, next to that column, and within the robot's
// reach (approach.h). A *policy* says for each observation which placements may be made; the
// robot cannot tell situations with the same observation apart, so a placement that a policy
// allows must be possible, and right, in all of them.
//
// The search begins with every placement allowed everywhere and takes away, until nothing is
// to be taken away:
//
//   - placements after which the structure can no longer be completed, wherever their
//     observation occurs (the block that closes the way to another site); where either of two
//     may be made but not both, and taking both away leaves too little, one of them;
//   - placements that are impossible or against the rules in some situation that can arise
//     and shows the same.
//
// What is left is *complete* when in no structure that it can lead to nothing is allowed,
// but the last one. Then every maximal order of allowed placements ends in the whole
// structure: each adds a brick, so it ends, and it can only end there. That is a theorem for
// one robot at a time that visits every side and column again and again; it is proved by
// walking all the structures that the policy can lead to.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/approach.h"
#include "compiler/sight.h"
#include "compiler/target_states.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// A brick next to a column: in front of it, on top of it, or beside it. On top: at (0, 0, 0),
/// whatever the level.
struct Placement {
  WindowCell at;
  Colour colour = 0;
  auto operator<=>(const Placement&) const = default;
};
enum class PlacementKind : std::uint8_t { raise, extend, beside };
PlacementKind kind_of(const Placement& placement);

struct Situation {
  std::uint32_t state = 0;  ///< number of the structure
  ApproachSide side{};
  int u = 0, v = 0;               ///< the column
  std::uint32_t observation = 0;  ///< number
  /// What is possible here, and the structure it leads to.
  std::vector<std::pair<Placement, std::uint32_t>> placements;
};

/// Why a placement was taken away from an observation.
struct Withdrawal {
  enum class Reason : std::uint8_t {
    dead_end,   ///< in situation `here` it leads where the structure cannot be completed
    ambiguous,  ///< possible in `here`, not in `there`, which shows the same
    unasked,    ///< wanted in `here`, wrong in `there`, and no question tells them apart
  } reason = Reason::dead_end;
  std::uint32_t observation = 0;
  Placement placement;
  std::uint32_t here = 0, there = 0;  ///< situations
};

struct Policy {
  std::vector<BrickSet> states;  ///< that can be reached by placements within reach
  std::vector<Situation> situations;
  std::vector<std::size_t> first;  ///< situations [first[s], first[s + 1]) are those of state s
  std::vector<Observation> observations;
  std::vector<std::set<Placement>> allowed;  ///< by observation
  std::vector<Withdrawal> withdrawn;
  std::vector<bool> reached;  ///< by state: under the policy
  bool complete = false;
  /// Not complete: a structure in which nothing is allowed, the fullest there is.
  std::optional<std::uint32_t> stuck;
  /// Not complete: no order of placements within reach, chosen by somebody who knows all,
  /// would do.
  bool out_of_reach = false;
  bool too_large = false;  ///< the limit of structures was met; nothing is known
};

struct PolicyLimits {
  std::size_t states = 100'000;
  const std::atomic<bool>* stop = nullptr;  ///< set by others: give up, as if the limit were met
};

/// Which placements next to a column are looked at.
enum class PlacementKinds : std::uint8_t { ahead, all };  ///< ahead: raise and extend alone

/// What a policy may rest on.
struct PolicyScope {
  PlacementKinds kinds = PlacementKinds::all;
  bool knows_side = false;  ///< what is seen from two sides is never the same
};

/// All structures that placements within reach lead to, with everything allowed.
Policy explore(const TargetStates& target, const Abilities& robot,
               const std::vector<ApproachSide>& sides, const PolicyScope& scope,
               const PolicyLimits& limits = {});

/// Bricks that may be placed in a structure, rising.
using OpenBricks = std::function<std::vector<std::uint32_t>(const BrickSet&)>;
/// The same for bricks that anything else than rules keeps in order.
Policy explore(const TargetBricks& target, const OpenBricks& open, Sight& sight,
               const Abilities& robot, const std::vector<ApproachSide>& sides,
               const PolicyScope& scope, const PolicyLimits& limits = {});

/// Where two placements may each be made, but not both, one of them has to go. at_once: all that
/// lead to a dead end, wherever they do; search: where that leaves no way to the whole structure,
/// one by one, by several orders of preference, the first that leaves one.
enum class Pruning : std::uint8_t { at_once, search };

/// Takes away what must be; sets what the policy says of itself. Again after more was
/// withdrawn.
void prune(const TargetBricks& target, Policy& policy, Pruning pruning = Pruning::at_once);
/// False when it was not allowed anyway.
bool withdraw(Policy& policy, const Withdrawal& withdrawal);

}  // namespace stig::compiler
