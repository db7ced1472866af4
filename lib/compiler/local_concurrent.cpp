// SPDX-License-Identifier: MIT
// Conflicts between robots, without a walk: every decision is compared with the least and
// the greatest closed structure around its brick. As long as decisions last in all
// structures between these, robots never leave the closed structures, so the proof of
// local_policy.h covers any number of them.
#include "compiler/local_concurrent.h"

#include <algorithm>
#include <map>
#include <set>

namespace stig::compiler {

namespace {

class LocalChecker {
 public:
  LocalChecker(CompiledRules& compiled, const Abilities& robot, const LocalSituations& local,
               const Precedence& precedence, Lanes& lanes, Crowd crowd)
      : compiled_(compiled),
        target_(*compiled.target),
        robot_(robot),
        local_(local),
        precedence_(precedence),
        lanes_(lanes),
        crowd_(crowd) {
    out_.structures = compiled.local_situations;
    out_.ways_cross = compiled.sides.size() > 2;
  }

  Concurrency check(const std::vector<Work>& decided) {
    for (const Work& work : decided) put_from_[work.brick].insert(work.side);
    for (const Work& work : decided) {
      look_whether_lasting(work);
      // Its robot stands before the site, among what comes before the brick.
      look_for_walls(work.side, site_of(work), before(work.brick), {});
    }
    for (const ApproachSide side : compiled_.sides) {
      for (const auto& [u, v] : local_.columns(side)) look_before_column(side, u, v);
    }
    std::sort(out_.conflicts.begin(), out_.conflicts.end(),
              [](const Conflict& a, const Conflict& b) { return a.kind < b.kind; });
    return out_;
  }

 private:
  SideCell site_of(const Work& work) const {
    SideCell out = seen_from(work.side, target_.cell(work.brick));
    out.z = target_.floor_level();
    return out;
  }

  /// The least that stands when the brick is due. Closed by definition: a brick's
  /// predecessors and the start.
  BrickSet before(std::uint32_t brick) const {
    BrickSet out = precedence_.below(brick);
    out.add(target_.start());
    out.remove(brick);
    return out;
  }

  bool has(ConflictKind kind) const {
    return std::any_of(out_.conflicts.begin(), out_.conflicts.end(),
                       [&](const Conflict& one) { return one.kind == kind; });
  }

  /// Conflicts need a structure to be drawn; it is added to the policy's list, where reports
  /// look for it.
  std::uint32_t number(const BrickSet& state) {
    Policy& policy = compiled_.policy;
    policy.states.push_back(state);
    policy.first.push_back(policy.situations.size());
    policy.reached.push_back(true);
    return static_cast<std::uint32_t>(policy.states.size() - 1);
  }

  void look_whether_lasting(const Work& work) {
    ++out_.pairs;
    const BrickSet least = before(work.brick);
    const BrickSet most = target_.others(precedence_.above(work.brick));
    const Cell cell = target_.cell(work.brick);
    if (target_.due_between(least, most, work.brick) &&
        reach_between(target_, least, most, lanes_.to(work.brick, work.side), cell, work.side,
                      robot_)) {
      return;
    }
    Conflict conflict;
    // The greatest structure shows which brick bars the way, if any single one does.
    conflict.reach = reach(target_, most, cell, work.side, robot_);
    const std::uint32_t bar = conflict.reach.obstruction == Obstruction::none
                                  ? TargetBricks::kNone
                                  : target_.brick_at(conflict.reach.where);
    conflict.kind = bar == TargetBricks::kNone ? ConflictKind::unwalked : ConflictKind::barred;
    if (has(conflict.kind)) return;
    BrickSet state = least;
    if (bar == TargetBricks::kNone) {
      conflict.placed = work;
    } else {
      state.add(before(bar));
      conflict.placed = Work{bar, compiled_.sides.front()};
      conflict.other = work;
    }
    conflict.state = conflict.decided_in = conflict.other_decided_in = number(state);
    out_.conflicts.push_back(conflict);
  }

  /// As deep as a robot can go: to put a block on top of the column, or in front of it.
  void look_before_column(ApproachSide side, int u, int v) {
    const std::vector<std::uint32_t> in_front = local_.in_front(side, u, v);
    for (int z = 0; z < target_.levels(); ++z) {
      const std::uint32_t brick =
          target_.brick_at(cell_from(side, {u, v, z + target_.floor_level()}));
      if (brick == TargetBricks::kNone) continue;
      BrickSet least = before(brick);
      least.add(brick);
      for (const int deepest : {u, u + 1}) {
        look_for_walls(side, {deepest, v, target_.floor_level()}, least, in_front);
      }
    }
  }

  /// May a robot other than the one that stands on this side put the brick?
  bool others_put(std::uint32_t brick, ApproachSide side) const {
    if (crowd_ == Crowd::any) return true;
    const auto from = put_from_.find(brick);
    return from != put_from_.end() && from->second.size() > from->second.count(side);
  }

  /// Can a brick be put behind a robot in this lane, when `least` stands and `missing` does
  /// not? A brick is harmless if it cannot be due while the robot stands there.
  void look_for_walls(ApproachSide side, const SideCell& stand, const BrickSet& least,
                      const std::vector<std::uint32_t>& missing) {
    if (has(ConflictKind::walled_in)) return;
    const Cell at = cell_from(side, stand);
    const BrickSet lane = lane_to(target_, at, side, robot_);
    BrickSet free = lane;
    for (const std::uint32_t brick : missing) free.add(brick);
    if (least.meets(free)) return;
    for (std::uint32_t brick = 0; brick < target_.bricks(); ++brick) {
      if (!lane.has(brick)) continue;
      if (!behind_robot(stand, seen_from(side, target_.cell(brick)), robot_)) continue;
      if (!others_put(brick, side)) continue;
      BrickSet state = before(brick);
      if (state.meets(free)) continue;
      state.add(least);
      Conflict conflict;
      conflict.kind = ConflictKind::walled_in;
      conflict.placed = Work{brick, side};
      conflict.column = at;
      conflict.stands_at = side;
      conflict.state = conflict.decided_in = number(state);
      out_.conflicts.push_back(conflict);
      return;
    }
  }

  CompiledRules& compiled_;
  const TargetStates& target_;
  const Abilities& robot_;
  const LocalSituations& local_;
  const Precedence& precedence_;
  Lanes& lanes_;
  const Crowd crowd_;
  std::map<std::uint32_t, std::set<ApproachSide>> put_from_;  ///< by brick, as is decided
  Concurrency out_;
};

}  // namespace

Concurrency check_locally(CompiledRules& compiled, const std::vector<Work>& decided,
                          const Abilities& robot, const LocalSituations& local,
                          const Precedence& precedence, Lanes& lanes) {
  const auto check = [&](Crowd crowd) {
    return LocalChecker(compiled, robot, local, precedence, lanes, crowd).check(decided);
  };
  Concurrency out = check(Crowd::any);
  if (!out.conflicts.empty() && compiled.sides.size() > 1) {
    out.one_a_side = check(Crowd::one_a_side).conflicts.empty();
  }
  return out;
}

}  // namespace stig::compiler
