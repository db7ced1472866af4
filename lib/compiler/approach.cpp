// SPDX-License-Identifier: MIT
// Geometry of one placement, on the grid: which cells must be free for body, block and
// effector, and whether the block is held afterwards. Checks come in the order in which an
// author can do something about them: height, way, site, effector, support. `reach` answers
// for one structure, `reach_between` for all structures between two, by taking for every
// condition the structure that is worst for it.
#include "compiler/approach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "rules/cell_text.h"

namespace stig::compiler {

namespace {

constexpr std::array<std::string_view, 4> kSideNames = {"+x", "-x", "+y", "-y"};

/// The part of a structure that a side looks at.
struct View3 {
  const TargetBricks& target;
  const BrickSet& state;
  ApproachSide side;

  bool filled(int u, int v, int z) const {
    return target.filled(state, cell_from(side, {u, v, z}));
  }
};

/// Rows to either side of its own that a robot's body reaches into.
int rows_beside(const Abilities& robot) {
  const double side = robot.block.side;
  return std::max(0, static_cast<int>(std::ceil((robot.body_half_width - side / 2) / side - 1e-9)));
}

/// The first brick that stands in the way of a robot to `site`.
std::optional<Cell> in_the_way(const View3& view, SideCell site, const Abilities& robot) {
  std::uint32_t first = TargetBricks::kNone;
  const int beside = rows_beside(robot);
  for (int v = site.v - beside; v <= site.v + beside; ++v) {
    for (const std::uint32_t i : row_from(view.target, view.side, v)) {
      if (i >= first) break;
      if (!view.state.has(i)) continue;
      if (in_lane(site, seen_from(view.side, view.target.cell(i)), robot)) first = i;
    }
  }
  return first == TargetBricks::kNone ? std::nullopt : std::optional(view.target.cell(first));
}

/// Do bricks bear the cell from the floor up?
bool grounded(const View3& view, const SideCell& at) {
  for (int z = view.target.floor_level(); z < at.z; ++z) {
    if (!view.filled(at.u, at.v, z)) return false;
  }
  return true;
}

/// What would hang, with this brick: how many, and their moments about the faces of the columns
/// that bear them, in those of one block, as if all hung on one joint.
struct Overhang {
  int blocks = 0;
  double moments = 0;
};
/// The bricks that hang together with the site are found by a flood over bricks that no
/// column bears; then each one's distance in steps from the nearest column is relaxed until
/// nothing changes, as in Bellman and Ford. The moment of a brick n steps out is 2n - 1
/// times that of the first.
Overhang overhang(const View3& view, const SideCell& site) {
  std::map<SideCell, int> from_column;  // steps aside from the nearest column
  std::vector<SideCell> hanging = {site};
  const auto near = [](const SideCell& c) {
    return std::array<SideCell, 6>{{{c.u + 1, c.v, c.z},
                                    {c.u - 1, c.v, c.z},
                                    {c.u, c.v + 1, c.z},
                                    {c.u, c.v - 1, c.z},
                                    {c.u, c.v, c.z + 1},
                                    {c.u, c.v, c.z - 1}}};
  };
  for (std::size_t i = 0; i < hanging.size(); ++i) {
    from_column.emplace(hanging[i], std::numeric_limits<int>::max());
    for (const SideCell& c : near(hanging[i])) {
      if (!view.filled(c.u, c.v, c.z) || grounded(view, c)) continue;
      if (std::find(hanging.begin(), hanging.end(), c) == hanging.end()) hanging.push_back(c);
    }
  }
  constexpr int kFar = std::numeric_limits<int>::max() / 2;
  for (bool nearer = true; nearer;) {
    nearer = false;
    for (const SideCell& at : hanging) {
      for (const SideCell& c : near(at)) {
        const auto known = from_column.find(c);
        const bool column = view.filled(c.u, c.v, c.z) && known == from_column.end();
        const int there = column ? 0 : known == from_column.end() ? kFar : known->second;
        const int steps = c.z == at.z ? 1 : 0;
        if (there >= kFar || there + steps >= from_column[at]) continue;
        from_column[at] = there + steps;
        nearer = true;
      }
    }
  }
  Overhang out;
  for (const auto& [at, steps] : from_column) {
    ++out.blocks;
    out.moments += 2.0 * steps - 1;
  }
  return out;
}

ReachResult support(const View3& view, SideCell site, const Abilities& robot) {
  if (grounded(view, site)) return {};
  const Cell below = cell_from(view.side, {site.u, site.v, site.z - 1});
  // The inset is the distance of the magnets from the edge, in m.
  const double side = robot.block.side, inset = 0.005;
  // The moment of the block's weight about the lower edge of the joint.
  const double moment = robot.block_weight * side / 2;
  if (!view.filled(site.u - 1, site.v, site.z) && !view.filled(site.u, site.v, site.z - 1)) {
    return {Obstruction::unsupported, below, moment, 0};
  }
  // A higher column behind keeps effector and block off it. What stands on something is drawn to
  // its place from there; what has nothing below falls.
  if (!view.filled(site.u, site.v, site.z - 1) && view.filled(site.u - 1, site.v, site.z + 1)) {
    return {Obstruction::held_off, cell_from(view.side, {site.u - 1, site.v, site.z + 1}), 0, 0};
  }
  // Let down against the face behind it, or on what hangs so, it hangs on a joint: half of
  // the magnets near the upper edge, half near the lower; friction must bear it too. A
  // joint opens about an edge, so the magnets' moments about that edge are what holds it.
  const Overhang hangs = overhang(view, site);
  const double factor = 1.5;  // what is let go swings a little
  const double hold = robot.face_hold / 2 * (side - inset) + robot.face_hold / 2 * inset;
  const double shear = robot.face_hold * robot.friction;
  if (factor * hangs.moments * moment >= hold) {
    return {Obstruction::overhang, below, factor * hangs.moments * moment, hold};
  }
  if (factor * hangs.blocks * robot.block_weight >= shear) {
    return {Obstruction::unsupported, below, factor * hangs.blocks * robot.block_weight, shear};
  }
  return {};
}

/// In every structure between two, the smaller of which says what stops the effector
/// behind. Bricks only get more from `least` to `view`: what stops the effector has to be
/// there for certain, what obstructs it need only be possible.
ReachResult effector(const View3& least, const View3& view, SideCell site, const Abilities& robot) {
  const double half = robot.block.side / 2;
  const double ahead = robot.effector_front - (robot.carried_x + half);
  if (ahead > robot.magnet_reach && view.filled(site.u - 1, site.v, site.z + 1)) {
    return {Obstruction::effector_blocked, cell_from(view.side, {site.u - 1, site.v, site.z + 1}),
            ahead, robot.magnet_reach};
  }
  const double beside = robot.effector_half_width - half;
  for (const int side : {-1, 1}) {
    if (beside > 0 && view.filled(site.u, site.v + side, site.z + 1)) {
      return {Obstruction::effector_blocked,
              cell_from(view.side, {site.u, site.v + side, site.z + 1}), beside, 0};
    }
    // A column straight behind stops the effector before it; without one its corners come over
    // those to the left and right of that.
    if (beside > 0 && ahead > 0 && !least.filled(site.u - 1, site.v, site.z + 1) &&
        view.filled(site.u - 1, site.v + side, site.z + 1)) {
      return {Obstruction::effector_blocked,
              cell_from(view.side, {site.u - 1, site.v + side, site.z + 1}), beside, 0};
    }
  }
  return {};
}

}  // namespace

std::string_view to_string(ApproachSide side) { return kSideNames[static_cast<std::size_t>(side)]; }

std::optional<ApproachSide> parse_side(std::string_view text) {
  const auto found = std::find(kSideNames.begin(), kSideNames.end(), text);
  if (found == kSideNames.end()) return std::nullopt;
  return static_cast<ApproachSide>(found - kSideNames.begin());
}

bool is_unheld(Obstruction obstruction) {
  return obstruction == Obstruction::unsupported || obstruction == Obstruction::overhang ||
         obstruction == Obstruction::held_off;
}

/// A robot at +x looks along -x: its left is -y. The four cases are the quarter turns about
/// the vertical; cell_from inverts each.
SideCell seen_from(ApproachSide side, Cell c) {
  switch (side) {
    case ApproachSide::plus_x:
      return {c.x, -c.y, c.z};
    case ApproachSide::minus_x:
      return {-c.x, c.y, c.z};
    case ApproachSide::plus_y:
      return {c.y, c.x, c.z};
    case ApproachSide::minus_y:
      return {-c.y, -c.x, c.z};
  }
  return {};
}

Cell cell_from(ApproachSide side, SideCell c) {
  switch (side) {
    case ApproachSide::plus_x:
      return {c.u, -c.v, c.z};
    case ApproachSide::minus_x:
      return {-c.u, c.v, c.z};
    case ApproachSide::plus_y:
      return {c.v, c.u, c.z};
    case ApproachSide::minus_y:
      return {-c.v, -c.u, c.z};
  }
  return {};
}

const std::vector<std::uint32_t>& row_from(const TargetBricks& target, ApproachSide side, int v) {
  const Cell at = cell_from(side, {0, v, 0});
  const bool along_x = side == ApproachSide::plus_x || side == ApproachSide::minus_x;
  return along_x ? target.with_y(at.y) : target.with_x(at.x);
}

bool in_lane(const SideCell& site, const SideCell& brick, const Abilities& robot) {
  const double side = robot.block.side;
  // Cells that the body reaches into, beyond the block's near face, in rows as far as its
  // half width goes. The gap is that between the block's near face and the body's front, so
  // cells closer than it stay free of the body.
  const double gap = robot.carried_x - side / 2 - robot.body_front;
  const int first = site.u + 1 + static_cast<int>(std::max(0.0, std::floor(gap / side)));
  const int across = std::abs(brick.v - site.v);
  if (brick.u >= first && across <= rows_beside(robot)) return true;
  // The block itself passes along its row.
  return brick.u > site.u && across == 0 && brick.z >= site.z;
}

bool behind_robot(const SideCell& site, const SideCell& brick, const Abilities& robot) {
  const double to_face = (brick.u - site.u - 0.5) * robot.block.side;
  return to_face >= robot.carried_x + robot.body_back;
}

/// The first obstruction is returned, with the figures that explain it.
ReachResult reach(const TargetBricks& target, const BrickSet& state, Cell cell, ApproachSide side,
                  const Abilities& robot) {
  assert(!target.filled(state, cell));
  const View3 view{target, state, side};
  const SideCell site = seen_from(side, cell);
  const int level = site.z - target.floor_level();
  if (level >= robot.levels) {
    return {Obstruction::too_high, cell, robot.lift_for(level), robot.lift_travel};
  }
  if (const auto brick = in_the_way(view, site, robot)) {
    return {Obstruction::body_blocked, *brick, robot.body_half_width, robot.block.side / 2};
  }
  if (view.filled(site.u, site.v, site.z + 1)) {
    return {Obstruction::covered, cell_from(side, {site.u, site.v, site.z + 1}), 0, 0};
  }
  if (view.filled(site.u, site.v - 1, site.z) && view.filled(site.u, site.v + 1, site.z)) {
    return {Obstruction::slot, cell_from(side, {site.u, site.v + 1, site.z}), robot.block.side,
            robot.block.side};
  }
  if (const ReachResult blocked = effector(view, view, site, robot);
      blocked.obstruction != Obstruction::none) {
    return blocked;
  }
  return support(view, site, robot);
}

/// Overhangs are left out: whether one holds depends on what else hangs there.
bool reach_between(const TargetBricks& target, const BrickSet& least, const BrickSet& most,
                   const BrickSet& lane, Cell cell, ApproachSide side, const Abilities& robot) {
  assert(most.contains(least));
  const View3 few{target, least, side}, many{target, most, side};
  const SideCell site = seen_from(side, cell);
  if (site.z - target.floor_level() >= robot.levels || most.meets(lane)) return false;
  if (many.filled(site.u, site.v, site.z + 1) || !grounded(few, site)) return false;
  if (many.filled(site.u, site.v - 1, site.z) && many.filled(site.u, site.v + 1, site.z)) {
    return false;
  }
  return effector(few, many, site, robot).obstruction == Obstruction::none;
}

BrickSet lane_to(const TargetBricks& target, Cell cell, ApproachSide side, const Abilities& robot) {
  const SideCell site = seen_from(side, cell);
  BrickSet out(target.bricks());
  const int beside = rows_beside(robot);
  for (int v = site.v - beside; v <= site.v + beside; ++v) {
    for (const std::uint32_t i : row_from(target, side, v)) {
      if (in_lane(site, seen_from(side, target.cell(i)), robot)) out.add(i);
    }
  }
  return out;
}

/// Figures are printed in mm and with the limit that they exceed, so that the message tells
/// by how much a robot would have to differ.
std::string explain(const ReachResult& result) {
  const double mm = 1e3;
  switch (result.obstruction) {
    case Obstruction::none:
      return "it can be reached";
    case Obstruction::too_high:
      return fmt::format("it needs the lift at {:.0f} mm, which goes to {:.1f} mm",
                         result.figure * mm, result.limit * mm);
    case Obstruction::body_blocked:
      return fmt::format(
          "the brick at {} stands where the robot, {:.1f} mm wide to each side, "
          "would have to",
          cell_text(result.where), result.figure * mm);
    case Obstruction::effector_blocked:
      if (result.limit > 0) {
        return fmt::format(
            "the end-effector meets the brick at {} and leaves the block {:.1f} mm off, more than "
            "the {:.0f} mm that magnets close",
            cell_text(result.where), result.figure * mm, result.limit * mm);
      }
      return fmt::format(
          "the end-effector is {:.1f} mm wider to that side than a block and meets "
          "the brick at {}",
          result.figure * mm, cell_text(result.where));
    case Obstruction::slot:
      return fmt::format("it is a slot of just a block's width ({:.0f} mm) between two bricks",
                         result.limit * mm);
    case Obstruction::covered:
      return fmt::format("the brick at {} lies over it", cell_text(result.where));
    case Obstruction::overhang:
      return fmt::format("magnets hold {:.2f} N m, and what would hang on them asks for {:.2f} N m",
                         result.limit, result.figure);
    case Obstruction::held_off:
      return fmt::format(
          "nothing is below it, and the brick at {} keeps the block off the one that it is to hang "
          "on: let go there it would fall",
          cell_text(result.where));
    case Obstruction::unsupported:
      if (result.limit == 0) {
        return fmt::format("nothing is below it at {} nor behind it to hang on",
                           cell_text(result.where));
      }
      return fmt::format(
          "nothing bears it from the floor up, and magnets with friction bear {:.2f} N of the "
          "{:.2f} N that would hang on them",
          result.limit, result.figure);
  }
  return {};
}

}  // namespace stig::compiler
