// SPDX-License-Identifier: MIT
// The proof column by column (local_policy.h has the argument). Situations are visited
// once; for each observation the intersection over its situations of what is right and in
// reach is allowed. Then the tree is made as for a walk, and finally it is shown that for
// each brick of some order a robot comes to a column where something is to be done.
#include "compiler/local_policy.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "compiler/columns.h"
#include "compiler/lanes.h"
#include "compiler/local_concurrent.h"
#include "compiler/local_situations.h"

namespace stig::compiler {

namespace {

/// Placements beside a column and the bricks that they make.
using Offers = std::map<Placement, std::uint32_t>;

class LocalPolicy {
 public:
  /// `lasting`: bricks are put from such sides alone as last, whatever other robots do.
  LocalPolicy(const Abilities& robot, const PolicyLimits& limits, const PolicyScope& scope,
              bool lasting, const Precedence& precedence, Lanes& lanes, CompiledRules& compiled)
      : robot_(robot),
        limits_(limits),
        scope_(scope),
        target_(*compiled.target),
        lasting_(lasting),
        precedence_(precedence),
        sight_(target_, compiled.visibility),
        local_(target_, precedence, sight_),
        lanes_(lanes),
        compiled_(compiled) {}

  bool settle() {
    if (!look_everywhere()) return false;
    Policy& policy = compiled_.policy;
    for (;;) {
      Decision decision = make_decision(policy);
      compiled_.decision = std::move(decision.root);
      if (compiled_.decision) break;
      for (const Withdrawal& one : decision.unasked) withdraw(policy, one);
    }
    return always_goes_on();
  }

  Concurrency concurrency() {
    std::vector<Work> decided;
    for (const auto& [work, ways] : offered_) {
      const bool ever = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
        return decide(*compiled_.decision, compiled_.policy.observations[way.first]) == way.second;
      });
      if (ever) decided.push_back(work);
    }
    return check_locally(compiled_, decided, robot_, local_, precedence_, lanes_);
  }

 private:
  bool stopped() const { return limits_.stop != nullptr && limits_.stop->load(); }

  bool look_everywhere() {
    Policy& policy = compiled_.policy;
    policy = {};
    policy.complete = true;
    // Two limits: one column must not use up what all share.
    std::size_t left = kMostLocalSituations;
    const BrickSet none(target_.bricks());
    for (const ApproachSide side : compiled_.sides) {
      for (const auto& [u, v] : local_.columns(side)) {
        std::size_t here = std::min(left, kMostAtColumn);
        const std::size_t before = here;
        if (stopped() || !local_.for_each(side, u, v, none, none, here,
                                          [&](const LocalSituation& at) { look(at); })) {
          return false;
        }
        left -= before - here;
      }
    }
    compiled_.local_situations = kMostLocalSituations - left;
    add_results();
    return true;
  }

  void look(const LocalSituation& at) {
    const std::uint32_t seen = observe(at);
    const Offers offers = offers_of(at);
    std::set<Placement>& allowed = compiled_.policy.allowed[seen];
    // Intersection over all situations with this observation, hence erased and never added
    // once it is known.
    if (known_[seen]) {
      std::erase_if(allowed, [&](const Placement& one) { return !offers.contains(one); });
    } else {
      for (const auto& [placement, brick] : offers) allowed.insert(placement);
      known_[seen] = true;
    }
    for (const auto& [placement, brick] : offers) {
      offered_[{brick, at.side}].emplace(seen, placement);
    }
    keep(at, seen, offers);
  }

  std::uint32_t observe(const LocalSituation& at) {
    Policy& policy = compiled_.policy;
    Observation seen = sight_.look(at.least, at.side, at.u, at.v);
    std::string key(seen.cells.begin(), seen.cells.end());
    if (scope_.knows_side) {
      // The side belongs to the observation only if a robot may rely on it.
      seen.side = at.side;
      key += to_string(at.side);
    }
    const auto [found, added] =
        seen_.emplace(std::move(key), static_cast<std::uint32_t>(policy.observations.size()));
    if (added) {
      policy.observations.push_back(std::move(seen));
      policy.allowed.emplace_back();
      known_.push_back(false);
    }
    return found->second;
  }

  /// What is right and within reach in all that looks so.
  Offers offers_of(const LocalSituation& at) {
    Offers out;
    for (const std::uint32_t brick : bricks_about(target_, at.side, at.u, at.v)) {
      if (at.most.has(brick)) continue;
      auto where = next_to_column(target_, at.least, at.side, at.u, at.v, brick);
      if (!where || (scope_.kinds == PlacementKinds::ahead && where->dv != 0)) continue;
      // Under `lasting`, only sides from which the brick can be put in every structure in
      // which it is due.
      if (!precedence_.all_before(at.least, brick) || (lasting_ && !lasts(brick, at.side)))
        continue;
      if (!target_.due_between(at.least, at.most, brick) ||
          !reach_between(target_, at.least, at.most, lanes_.to(brick, at.side), target_.cell(brick),
                         at.side, robot_)) {
        continue;
      }
      // On top of a column the level is what the column has; the placement does not name
      // it.
      if (where->du == 0 && where->dv == 0) where->z = 0;
      out.emplace(Placement{*where, target_.colour(brick)}, brick);
    }
    return out;
  }

  /// One situation of all that stand around alike is enough for what comes after.
  void keep(const LocalSituation& at, std::uint32_t seen, const Offers& offers) {
    std::string key(to_string(at.side));
    for (const WindowCell& cell : around_) {
      const std::uint32_t brick = target_.brick_at(
          cell_from(at.side, {at.u + cell.du, at.v + cell.dv, cell.z + target_.floor_level()}));
      const bool there = brick != TargetBricks::kNone && at.least.has(brick);
      key += there ? static_cast<char>(target_.colour(brick)) : '\0';
    }
    if (!kept_.emplace(std::move(key), 0).second) return;
    Policy& policy = compiled_.policy;
    const auto state = static_cast<std::uint32_t>(policy.states.size());
    policy.states.push_back(at.least);
    Situation situation{state, at.side, at.u, at.v, seen, {}};
    for (const auto& [placement, brick] : offers)
      situation.placements.emplace_back(placement, brick);
    policy.situations.push_back(std::move(situation));
  }

  /// What placements lead to, as states of their own in which nothing is looked at.
  /// Policies are lists of structures; here they hold only examples, so that texts and
  /// drawings work as for a walk.
  void add_results() {
    Policy& policy = compiled_.policy;
    for (std::size_t i = 0; i < policy.situations.size(); ++i) {
      policy.first.push_back(i);
      for (auto& [placement, to] : policy.situations[i].placements) {
        BrickSet after = policy.states[policy.situations[i].state];
        after.add(to);
        to = static_cast<std::uint32_t>(policy.states.size());
        policy.states.push_back(std::move(after));
      }
    }
    policy.first.resize(policy.states.size() + 1, policy.situations.size());
    policy.reached.assign(policy.states.size(), true);
  }

  /// Has each brick its way on in some order?
  bool always_goes_on() {
    compiled_.ways_on.clear();
    return can_go_on(target_, precedence_, [&](std::uint32_t q, const BrickSet& before) {
      return !stopped() && has_way_on(q, before);
    });
  }

  /// Can the brick be put from there in all structures in which it is due?
  bool lasts(std::uint32_t brick, ApproachSide side) {
    const auto [known, added] = lasts_.emplace(Work{brick, side}, false);
    if (added) {
      known->second = always_in_reach(target_, precedence_, lanes_, robot_, brick, side);
    }
    return known->second;
  }

  /// Columns next to the site are tried from all sides until one serves.
  bool has_way_on(std::uint32_t q, const BrickSet& before) {
    for (const ApproachSide side : compiled_.sides) {
      const SideCell site = seen_from(side, target_.cell(q));
      for (const auto& [du, dv] : kColumnsAbout) {
        if (!goes_on_at(side, site.u + du, site.v + dv, q, before)) continue;
        compiled_.ways_on.push_back({q, side, du, dv});
        return true;
      }
    }
    return false;
  }

  bool goes_on_at(ApproachSide side, int u, int v, std::uint32_t q, const BrickSet& before) {
    if (!local_.always_comes(side, u, v, q, before)) return false;
    bool goes_on = true;
    std::size_t most = kMostAtColumn;
    const bool all = local_.for_each(
        side, u, v, before, precedence_.above(q), most, [&](const LocalSituation& at) {
          Observation seen = sight_.look(at.least, side, u, v);
          seen.side = side;
          goes_on = goes_on && decide(*compiled_.decision, seen).has_value();
        });
    // The budget may run out, which means that nothing is known and not that nothing goes
    // on.
    return all && goes_on;
  }

  const Abilities& robot_;
  const PolicyLimits& limits_;
  const PolicyScope& scope_;
  const TargetStates& target_;
  const bool lasting_;
  const Precedence& precedence_;
  Sight sight_;
  LocalSituations local_;
  Lanes& lanes_;
  CompiledRules& compiled_;
  const std::vector<WindowCell> around_ = sight_.cells_that_matter();
  std::unordered_map<std::string, std::uint32_t> seen_, kept_;
  /// By brick and side: observations in which it may be put, and how.
  std::map<Work, std::set<std::pair<std::uint32_t, Placement>>> offered_;
  std::map<Work, bool> lasts_;
  std::vector<bool> known_;  ///< by observation: was it met before?
};

}  // namespace

bool settle_locally(const Abilities& robot, const PolicyLimits& limits, CompiledRules& compiled) {
  if (compiled.target->bricks() > kMostOrderedBricks) return false;
  const auto ordered = std::make_shared<Precedence>(precedence_of(*compiled.target));
  Precedence& precedence = *ordered;
  Lanes lanes(*compiled.target, robot);
  wait_for_lanes(*compiled.target, compiled.sides, robot, lanes, precedence);
  compiled.precedence = ordered;
  compiled.visibility =
      std::make_shared<Visibility>(robot, window_levels(robot, compiled.target->levels()));
  // Placements that last are tried first: they are safe for several robots. The others
  // serve one.
  for (const bool lasting : {true, false}) {
    for (const PolicyScope& scope : policy_scopes(compiled)) {
      LocalPolicy policy(robot, limits, scope, lasting, precedence, lanes, compiled);
      if (policy.settle()) {
        compiled.concurrency = policy.concurrency();
        return true;
      }
      compiled.decision.reset();
      compiled.local_situations = 0;
      if (limits.stop != nullptr && limits.stop->load()) return false;
    }
  }
  return false;
}

}  // namespace stig::compiler
