// SPDX-License-Identifier: MIT
// Is what stands at a site the structure that was proved, and was every brick placed as the rules
// say? Of several structures each is judged by itself.
//
// Three things are held to the rules, none of which asks a robot what it believes:
//
//     the end      every brick of the structure has come to rest in its cell (validate/watch.h) and
//                  shows its colour, within 2 mm and 2° of the lattice that fits all bricks best,
//                  and each of its neighbours; nothing else lies in or against the structure
//     the order    each placement, in the order in which bricks came to rest, was an event that
//                  some rule allowed in the structure as it stood then
//     the verdict  complete: both hold. incomplete: bricks are missing, what is there is right.
//                  wrong: something is there that should not be, or came when it should not
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "validate/uses.h"
#include "validate/watch.h"

namespace stig::validate {

struct Closeness {
  double way = 0.002;    ///< m
  double turn = 0.0349;  ///< rad
};

/// A brick of the structure as it stands.
struct BrickCheck {
  Cell cell;
  Colour wanted = 0;
  bool start = false;
  std::optional<std::size_t> block;  ///< none: missing
  Led led = Led::off;                ///< that it shows
  Vec3 off;                          ///< m, from its place in the fitted lattice, along its axes
  double yaw = 0, turn = 0;          ///< rad, likewise
  Vec3 drift;                        ///< m, from its place in the lattice of the start
  bool close = false, coloured = false;
  bool dead = false;  ///< all LEDs of the block are
};

/// A block that should not be where it is.
struct StrayBrick {
  std::size_t block = 0;
  Cell cell;  ///< the nearest
  Led led = Led::off;
  Vec3 off;              ///< m
  double yaw = 0;        ///< rad
  bool in_cell = false;  ///< in a cell of the lattice; otherwise between cells
};

/// A placement that no rule allowed.
struct AgainstRules {
  std::size_t event = 0;  ///< of this structure's
  std::string reason;     ///< a sentence
};

/// Two neighbours that are too far off or turned against each other.
struct LooseJoint {
  Cell a, b;
  double way = 0, turn = 0;  ///< m, rad
};

enum class BuildVerdict : std::uint8_t { complete, incomplete, wrong };
std::string_view to_string(BuildVerdict verdict);

struct Judgement {
  BuildVerdict verdict = BuildVerdict::incomplete;
  std::vector<BrickCheck> bricks;           ///< of the structure, start first, then by level
  std::vector<StrayBrick> extra;            ///< against what is built, or in its way
  std::size_t placements = 0, allowed = 0;  ///< in a row from the first
  std::optional<AgainstRules> against;
  /// The worst of the bricks that are there, and of neighbours, one against the other.
  double worst_way = 0, worst_turn = 0, worst_joint_way = 0, worst_joint_turn = 0;
  double worst_drift = 0;
  std::vector<LooseJoint> loose;  ///< neighbours that are not close

  std::size_t missing() const;
};

/// One of the target's structures. `blocks`: all that are in the arena and that no robot holds;
/// `events`: of all structures.
Judgement judge(const BuildTarget& target, std::size_t structure,
                const std::vector<WatchedBlock>& blocks, const std::vector<BrickEvent>& events,
                const Closeness& closeness = {});

/// Every brick is in its cell in its colour, and none besides: what a watch alone can tell.
bool stands(const BuildTarget& target, std::size_t structure, const Watch& watch);

/// There is a brick where none should be, or one of another colour.
bool spoilt(const BuildTarget& target, std::size_t structure, const Watch& watch);

/// "Q3 brick at (0, 0, 2)", for reports.
std::string brick_text(const RuleSet& rules, Led led, Cell cell);

}  // namespace stig::validate
