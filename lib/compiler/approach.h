// SPDX-License-Identifier: MIT
// From where a robot can put a block where.
//
// A robot works from one of four sides. Seen from there, a cell has three coordinates:
//
//     u   towards the robot        (side +x: u = x)
//     v   to the robot's left      (facing the structure: side +x looks along -x, so v = -y)
//     z   up, from the floor
//
//                       u ──►
//        [ ][ ][q] ◄── block ── robot
//
// It drives up along -u with the block before it, aligned with the row v, lets it down on
// what is below, and leaves by the way it came. Its body needs the cells behind the block
// free, in the rows on either side too where it is wider than a block, at every level: lift
// and camera tower above any structure it can build. Its end-effector lies on the block and
// sticks out beyond: what stands there keeps the block at a distance, which magnets close if
// it is small enough.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/abilities.h"
#include "compiler/target_bricks.h"
#include "compiler/uses.h"

namespace stig::compiler {

enum class ApproachSide : std::uint8_t { plus_x, minus_x, plus_y, minus_y };
inline constexpr std::array<ApproachSide, 4> kAllSides = {
    ApproachSide::plus_x, ApproachSide::plus_y, ApproachSide::minus_x, ApproachSide::minus_y};
std::string_view to_string(ApproachSide side);  ///< "+x"
std::optional<ApproachSide> parse_side(std::string_view text);

/// A cell as seen from a side.
struct SideCell {
  int u = 0, v = 0, z = 0;
  auto operator<=>(const SideCell&) const = default;
};
SideCell seen_from(ApproachSide side, Cell cell);
Cell cell_from(ApproachSide side, SideCell cell);

enum class Obstruction : std::uint8_t {
  none,
  too_high,          ///< the lift does not reach
  body_blocked,      ///< a brick stands where the robot would
  effector_blocked,  ///< a brick keeps the end-effector, and so the block, too far off
  slot,              ///< bricks on both sides leave a gap of just a block's width
  covered,           ///< a brick lies on the site
  unsupported,       ///< nothing below, and no joint of magnets that would hold it
  overhang,          ///< it would hang on a joint that does not bear it and what hangs there
  held_off,  ///< it would hang, and is let go off the face that bears it, before a brick over that
};

/// Does nothing hold the brick, as things stand? More may come that does.
bool is_unheld(Obstruction obstruction);

struct ReachResult {
  Obstruction obstruction = Obstruction::none;
  Cell where;         ///< the brick in the way
  double figure = 0;  ///< what is asked for: m of height, of gap; N·m of hold
  double limit = 0;   ///< what there is
};

/// Can a block be put into this empty cell from this side, as things stand?
ReachResult reach(const TargetBricks& target, const BrickSet& state, Cell cell, ApproachSide side,
                  const Abilities& robot);
/// Does a brick here stand in the lane of a robot at `site`: the cells that its body passes on
/// the way there and back?
bool in_lane(const SideCell& site, const SideCell& brick, const Abilities& robot);
/// Bricks of the row v as the side sees it, rising.
const std::vector<std::uint32_t>& row_from(const TargetBricks& target, ApproachSide side, int v);
/// Does a cell of that lane lie behind the robot when it is as deep in the lane as it goes?
bool behind_robot(const SideCell& site, const SideCell& brick, const Abilities& robot);
/// The bricks of the whole structure that stand in it.
BrickSet lane_to(const TargetBricks& target, Cell cell, ApproachSide side, const Abilities& robot);
/// Can a block be put there in every structure that has all of `least` and nothing beyond `most`?
/// `lane` is that of the cell. False too for one that would hang on a joint.
bool reach_between(const TargetBricks& target, const BrickSet& least, const BrickSet& most,
                   const BrickSet& lane, Cell cell, ApproachSide side, const Abilities& robot);
/// "needs the lift at 168 mm, it goes to 137 mm": a sentence's end.
std::string explain(const ReachResult& result);

}  // namespace stig::compiler
