// SPDX-License-Identifier: MIT
// Walks the structures that several robots can bring about and carries along what may be
// pending: decisions made and not yet carried out, and places where robots may stand. Sets
// of these are joined over all ways to a structure, so combinations that no single history
// has are checked as well; what passes holds for every number of robots. Cost: structures x
// pairs of pending decisions.
#include "compiler/concurrent.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>

namespace stig::compiler {

namespace {

/// A lane in which a robot may be: the side, and the deepest place in it as that side sees it.
struct Stand {
  ApproachSide side{};
  SideCell deepest;
  auto operator<=>(const Stand&) const = default;
};

/// Lanes of one or of opposite sides are parallel and never cross.
bool across(ApproachSide a, ApproachSide b) {
  const auto along_x = [](ApproachSide side) {
    return side == ApproachSide::plus_x || side == ApproachSide::minus_x;
  };
  return along_x(a) != along_x(b);
}

/// Can a robot in lane `b` be in the way of one that leaves by lane `a`? The sides are at a
/// right angle. What is compared are distances along lane a, in m, from the robot that
/// leaves to the one in lane b.
bool can_bar(const Stand& a, const Stand& b, const Abilities& robot) {
  const double side = robot.block.side, wide = robot.body_half_width;
  const SideCell at = seen_from(a.side, cell_from(b.side, b.deepest));
  if ((at.u - a.deepest.u) * side - wide < robot.carried_x + robot.body_back) return false;
  // Outwards in lane b is to the left of lane a, or to the right.
  const SideCell out =
      seen_from(a.side, cell_from(b.side, {b.deepest.u + 1, b.deepest.v, b.deepest.z}));
  const double inwards = (a.deepest.v - at.v) * (out.v - at.v) * side;
  return inwards + wide >= robot.carried_x - robot.effector_front;
}

class Checker {
 public:
  Checker(const TargetStates& target, const Abilities& robot, const Policy& policy,
          const DecisionNode& decision, Crowd crowd)
      : target_(target), robot_(robot), policy_(policy), decision_(decision), crowd_(crowd) {
    for (std::uint32_t s = 0; s < policy.states.size(); ++s) numbers_.emplace(policy.states[s], s);
    for (const Situation& at : policy.situations) sides_.insert(at.side);
    // The start has number 0.
    met_.resize(policy.states.size());
    met_[0].met = true;
  }

  std::size_t sides() const { return sides_.size(); }

  Concurrency check() {
    // A placement leads to more bricks, and numbers rise with the count of bricks (policy.h).
    for (std::uint32_t s = 0; s < met_.size(); ++s) {
      if (met_[s].met) visit(s);
      met_[s] = {};
    }
    std::sort(out_.conflicts.begin(), out_.conflicts.end(),
              [](const Conflict& a, const Conflict& b) { return a.kind < b.kind; });
    return out_;
  }

 private:
  /// Decided in structure `since`, not carried out yet.
  struct Pending {
    Work work;
    std::uint32_t since = 0;
  };
  struct Met {
    bool met = false;
    std::optional<Pending> by;  ///< the last placement on the first way that led here
    std::map<Work, std::uint32_t> pending;
    std::set<Stand> stands;
  };

  void visit(std::uint32_t s) {
    ++out_.structures;
    look(s);
    const Met here = met_[s];
    look_for_crossings(here.stands);
    for (const auto& [work, since] : here.pending) place(s, here, {work, since});
  }

  /// One example of each kind is enough for a report.
  void report(const Conflict& conflict) {
    const auto same = [&](const Conflict& one) { return one.kind == conflict.kind; };
    if (std::none_of(out_.conflicts.begin(), out_.conflicts.end(), same)) {
      out_.conflicts.push_back(conflict);
    }
  }

  Conflict conflict_in(std::uint32_t s, ConflictKind kind) const {
    Conflict out;
    out.kind = kind;
    out.state = s;
    if (const auto& by = met_[s].by) {
      out.placed = by->work;
      out.decided_in = by->since;
    }
    return out;
  }

  Cell foot(ApproachSide side, int u, int v) const {
    return cell_from(side, {u, v, target_.floor_level()});
  }

  /// What robots that come to the structure decide there. A decision that is not among the
  /// situation's placements is one that the policy never checked here.
  void look(std::uint32_t s) {
    const BrickSet& state = policy_.states[s];
    bool something = false;
    for (std::size_t i = policy_.first[s]; i < policy_.first[s + 1]; ++i) {
      const Situation& at = policy_.situations[i];
      if (const auto stand = stand_before(state, at)) met_[s].stands.insert(*stand);
      const auto wish = decide(decision_, policy_.observations[at.observation]);
      if (!wish) continue;
      const auto same = [&](const auto& step) { return step.first == *wish; };
      const auto found = std::find_if(at.placements.begin(), at.placements.end(), same);
      if (found == at.placements.end()) {
        Conflict conflict = conflict_in(s, ConflictKind::misled);
        conflict.column = foot(at.side, at.u, at.v);
        conflict.stands_at = at.side;
        report(conflict);
        continue;
      }
      const auto brick = brick_added(state, policy_.states[found->second], target_.bricks());
      met_[s].pending.emplace(Work{brick, at.side}, s);
      // Beside the column it stands in another row.
      SideCell site = seen_from(at.side, target_.cell(brick));
      site.z = target_.floor_level();
      met_[s].stands.insert({at.side, site});
      something = true;
    }
    if (!something && !target_.complete(state)) report(conflict_in(s, ConflictKind::stuck));
  }

  /// As deep as the robot can go before a column: to put a block on top, or else in front of it.
  std::optional<Stand> stand_before(const BrickSet& state, const Situation& at) const {
    for (const int u : {at.u, at.u + 1}) {
      const Stand stand{at.side, {u, at.v, target_.floor_level()}};
      bool free = true;
      for (std::size_t i = 0; i < target_.bricks() && free; ++i) {
        free =
            !state.has(i) || !in_lane(stand.deepest, seen_from(at.side, target_.cell(i)), robot_);
      }
      if (free) return stand;
    }
    return std::nullopt;
  }

  void look_for_crossings(const std::set<Stand>& stands) {
    // With two sides robots wait for each other in one direction at most, and no circle
    // closes.
    if (sides_.size() < 3) return;
    for (const Stand& a : stands) {
      for (const Stand& b : stands) {
        out_.ways_cross = out_.ways_cross || (across(a.side, b.side) && can_bar(a, b, robot_));
      }
    }
  }

  /// One robot puts its brick, while others stand about and have decided what is pending.
  /// Placing leads to a structure with a higher number, so every structure is complete when
  /// its turn comes.
  void place(std::uint32_t s, const Met& here, const Pending& one) {
    BrickSet after = policy_.states[s];
    after.add(one.work.brick);
    Conflict conflict = conflict_in(s, ConflictKind::unwalked);
    conflict.placed = one.work;
    conflict.decided_in = one.since;
    const auto number = numbers_.find(after);
    if (number == numbers_.end()) return report(conflict);
    Met& next = met_[number->second];
    if (!next.met) next.by = one;
    next.met = true;
    keep_stands(here, one, next, conflict);
    keep_pending(here, one, after, next, conflict);
  }

  /// Is the robot on that side the one that has put its brick, and has to look anew?
  bool is_the_same(ApproachSide side, const Pending& one) const {
    return crowd_ == Crowd::one_a_side && side == one.work.side;
  }

  /// Robots where the brick comes have left, or it would not be put there; those behind it must
  /// not be shut in.
  void keep_stands(const Met& here, const Pending& one, Met& next, Conflict conflict) {
    for (const Stand& stand : here.stands) {
      if (is_the_same(stand.side, one)) continue;
      const SideCell brick = seen_from(stand.side, target_.cell(one.work.brick));
      if (!in_lane(stand.deepest, brick, robot_)) {
        next.stands.insert(stand);
      } else if (behind_robot(stand.deepest, brick, robot_)) {
        conflict.kind = ConflictKind::walled_in;
        conflict.column = cell_from(stand.side, stand.deepest);
        conflict.stands_at = stand.side;
        report(conflict);
      }
    }
  }

  /// A pending decision survives if it is still allowed and in reach; otherwise it is a
  /// conflict.
  void keep_pending(const Met& here, const Pending& one, const BrickSet& after, Met& next,
                    Conflict conflict) {
    for (const auto& [work, since] : here.pending) {
      if (work.brick == one.work.brick || is_the_same(work.side, one)) continue;
      ++out_.pairs;
      conflict.other = work;
      conflict.other_decided_in = since;
      conflict.reach = reach(target_, after, target_.cell(work.brick), work.side, robot_);
      if (!target_.rule_for(after, work.brick)) {
        conflict.kind = ConflictKind::outdated;
      } else if (conflict.reach.obstruction != Obstruction::none) {
        conflict.kind = ConflictKind::barred;
      } else {
        next.pending.emplace(work, since);
        continue;
      }
      report(conflict);
    }
  }

  const TargetStates& target_;
  const Abilities& robot_;
  const Policy& policy_;
  const DecisionNode& decision_;
  const Crowd crowd_;
  std::map<BrickSet, std::uint32_t> numbers_;
  std::set<ApproachSide> sides_;
  std::vector<Met> met_;
  Concurrency out_;
};

}  // namespace

std::string_view to_string(ConflictKind kind) {
  constexpr std::string_view kNames[] = {"stuck",    "misled", "walled_in",
                                         "outdated", "barred", "unwalked"};
  return kNames[static_cast<std::size_t>(kind)];
}

Concurrency check_concurrency(const TargetStates& target, const Abilities& robot,
                              const Policy& policy, const DecisionNode& decision) {
  assert(policy.complete);
  Checker any(target, robot, policy, decision, Crowd::any);
  Concurrency out = any.check();
  if (!out.conflicts.empty() && any.sides() > 1) {
    Checker fewer(target, robot, policy, decision, Crowd::one_a_side);
    out.one_a_side = fewer.check().conflicts.empty();
  }
  return out;
}

}  // namespace stig::compiler
