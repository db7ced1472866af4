// SPDX-License-Identifier: MIT
// Explores all structures that robots can bring about, breadth first, and prunes placements
// until what remains is sound and complete (policy.h). Placements are withdrawn for
// observations and not for situations, since robots cannot tell situations with one
// observation apart; that is what makes pruning interact, and why a greedy order can fail
// where another succeeds.
#include "compiler/policy.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <unordered_map>

#include "base/hash.h"
#include "compiler/columns.h"

namespace stig::compiler {

namespace {

struct SetHash {
  std::size_t operator()(const BrickSet& set) const { return static_cast<std::size_t>(set.hash()); }
};

/// Walks every structure that placements within reach lead to.
class Explorer {
 public:
  Explorer(const TargetBricks& target, const OpenBricks& open, Sight& sight, const Abilities& robot,
           const std::vector<ApproachSide>& sides, const PolicyScope& scope,
           const PolicyLimits& limits, Policy& out)
      : target_(target),
        open_(open),
        sight_(sight),
        robot_(robot),
        sides_(sides),
        scope_(scope),
        limits_(limits),
        out_(out) {}

  void explore() {
    // The start has number 0, and numbers rise with the number of bricks: an event adds
    // one.
    number(target_.start());
    for (std::uint32_t s = 0; s < out_.states.size(); ++s) {
      out_.first.push_back(out_.situations.size());
      visit(s);
      const bool stopped = limits_.stop != nullptr && limits_.stop->load();
      if (stopped || out_.states.size() > limits_.states) {
        out_.too_large = true;
        return;
      }
    }
    out_.first.push_back(out_.situations.size());
  }

 private:
  std::uint32_t number(const BrickSet& state) {
    const auto [at, added] =
        numbers_.emplace(state, static_cast<std::uint32_t>(out_.states.size()));
    if (added) out_.states.push_back(state);
    return at->second;
  }

  /// Observations are numbered by what is seen; many situations share one.
  std::uint32_t observe(const BrickSet& state, ApproachSide side, int u, int v) {
    Observation seen = sight_.look(state, side, u, v);
    std::string key(seen.cells.begin(), seen.cells.end());
    if (scope_.knows_side) {
      seen.side = side;
      key += to_string(side);
    }
    const auto [at, added] =
        seen_.emplace(key, static_cast<std::uint32_t>(out_.observations.size()));
    if (added) out_.observations.push_back(seen);
    return at->second;
  }

  void visit(std::uint32_t s) {
    const BrickSet state = out_.states[s];  // a copy: the list grows
    const std::vector<std::uint32_t> open = open_(state);
    for (const ApproachSide side : sides_) {
      for (const auto& [v, u] : columns_before(target_, state, side)) {
        Situation situation{s, side, u, v, observe(state, side, u, v), {}};
        for (const std::uint32_t brick : open) {
          if (auto found = placement(state, situation, brick)) {
            situation.placements.push_back(*found);
          }
        }
        std::sort(situation.placements.begin(), situation.placements.end());
        out_.situations.push_back(std::move(situation));
      }
    }
  }

  /// A placement is offered only where the rules allow the brick, it is next to the column,
  /// and the robot can reach it.
  std::optional<std::pair<Placement, std::uint32_t>> placement(const BrickSet& state,
                                                               const Situation& at,
                                                               std::uint32_t brick) {
    std::optional<WindowCell> cell = next_to_column(target_, state, at.side, at.u, at.v, brick);
    if (!cell || (scope_.kinds == PlacementKinds::ahead && cell->dv != 0)) return std::nullopt;
    if (reach(target_, state, target_.cell(brick), at.side, robot_).obstruction !=
        Obstruction::none) {
      return std::nullopt;
    }
    if (cell->du == 0 && cell->dv == 0) cell->z = 0;
    BrickSet after = state;
    after.add(brick);
    return std::pair(Placement{*cell, target_.colour(brick)}, number(after));
  }

  const TargetBricks& target_;
  const OpenBricks& open_;
  Sight& sight_;
  const Abilities& robot_;
  const std::vector<ApproachSide>& sides_;
  const PolicyScope& scope_;
  const PolicyLimits& limits_;
  Policy& out_;
  std::unordered_map<BrickSet, std::uint32_t, SetHash> numbers_;
  std::map<std::string, std::uint32_t> seen_;
};

/// Takes placements away until what is left is sound.
class Pruner {
 public:
  /// Ranks what is allowed where; of dead ends the one of the least rank is withdrawn at a time.
  /// None: all at once.
  using Rank = std::function<std::uint64_t(const Observation&, const Placement&)>;

  Pruner(const TargetBricks& target, Policy& policy, Rank rank = {})
      : target_(target), out_(policy), rank_(std::move(rank)) {}

  /// `effort`, in structures that are looked at, is used up; without any left, it gives up,
  /// and the policy is not complete. Marking is linear in steps; each round withdraws
  /// something, so it ends.
  void prune(std::size_t& effort) {
    mark();
    if (out_.withdrawn.empty()) out_.out_of_reach = !hopeful_[0];
    while (hopeful_[0] && (withdraw_dead_ends() || withdraw_ambiguous())) {
      mark();
      if (effort < out_.states.size()) return;
      effort -= out_.states.size();
    }
    out_.complete = hopeful_[0];
    if (!out_.complete) out_.stuck = fullest_stuck();
  }

 private:
  bool may(const Situation& situation, const Placement& placement) const {
    return out_.allowed[situation.observation].contains(placement);
  }

  template <class Visit>
  void for_each_step(std::uint32_t state, const Visit& visit) const {
    for (std::size_t i = out_.first[state]; i < out_.first[state + 1]; ++i) {
      const Situation& situation = out_.situations[i];
      for (const auto& [placement, to] : situation.placements) {
        if (may(situation, placement)) visit(static_cast<std::uint32_t>(i), placement, to);
      }
    }
  }

  /// Which structures can be reached, and from which the whole one can.
  void mark() {
    // Bricks are only added, so later numbers never lead to earlier ones of fewer bricks;
    // numbers rise with the count of bricks, since states are found breadth first.
    const std::size_t count = out_.states.size();
    out_.reached.assign(count, false);
    out_.reached[0] = true;
    for (std::uint32_t s = 0; s < count; ++s) {
      if (!out_.reached[s]) continue;
      for_each_step(
          s, [&](std::uint32_t, const Placement&, std::uint32_t to) { out_.reached[to] = true; });
    }
    hopeful_.assign(count, false);
    for (std::size_t s = count; s-- > 0;) {
      hopeful_[s] = target_.complete(out_.states[s]);
      for_each_step(static_cast<std::uint32_t>(s),
                    [&](std::uint32_t, const Placement&, std::uint32_t to) {
                      hopeful_[s] = hopeful_[s] || hopeful_[to];
                    });
    }
  }

  /// All dead ends at once is quick, but may withdraw both of two placements that only
  /// exclude each other; then single withdrawals are tried in random preference orders.
  bool withdraw_dead_ends() {
    std::vector<Withdrawal> found;
    for (std::uint32_t s = 0; s < out_.states.size(); ++s) {
      if (!out_.reached[s] || !hopeful_[s]) continue;
      for_each_step(s, [&](std::uint32_t i, const Placement& placement, std::uint32_t to) {
        if (hopeful_[to]) return;
        found.push_back(
            {Withdrawal::Reason::dead_end, out_.situations[i].observation, placement, i, i});
      });
    }
    if (rank_ && !found.empty()) {
      const auto rank = [&](const Withdrawal& one) {
        return rank_(out_.observations[one.observation], one.placement);
      };
      found = {*std::min_element(
          found.begin(), found.end(),
          [&](const Withdrawal& a, const Withdrawal& b) { return rank(a) < rank(b); })};
    }
    for (const Withdrawal& one : found) withdraw(out_, one);
    return !found.empty();
  }

  /// A placement has to be possible in every reached situation that shows its observation.
  bool withdraw_ambiguous() {
    // Where each placement is possible, for the report.
    std::map<std::pair<std::uint32_t, Placement>, std::uint32_t> possible;
    for_each_situation([&](std::uint32_t i, const Situation& situation) {
      for (const auto& [placement, to] : situation.placements) {
        possible.emplace(std::pair(situation.observation, placement), i);
      }
    });
    std::vector<Withdrawal> found;
    for_each_situation([&](std::uint32_t i, const Situation& situation) {
      for (const Placement& placement : out_.allowed[situation.observation]) {
        const auto same = [&](const auto& step) { return step.first == placement; };
        if (std::any_of(situation.placements.begin(), situation.placements.end(), same)) continue;
        const auto here = possible.find({situation.observation, placement});
        if (here == possible.end()) continue;
        found.push_back(
            {Withdrawal::Reason::ambiguous, situation.observation, placement, here->second, i});
      }
    });
    for (const Withdrawal& one : found) withdraw(out_, one);
    return !found.empty();
  }

  template <class Visit>
  void for_each_situation(const Visit& visit) const {
    for (std::uint32_t i = 0; i < out_.situations.size(); ++i) {
      if (out_.reached[out_.situations[i].state]) visit(i, out_.situations[i]);
    }
  }

  /// The fullest structure that can be reached and goes no further, by the policy before it
  /// failed or, where nothing would do, by any placements.
  std::uint32_t fullest_stuck() const {
    std::uint32_t best = 0;
    std::size_t most = 0;
    for (std::uint32_t s = 0; s < out_.states.size(); ++s) {
      bool goes_on = false;
      for_each_step(s, [&](std::uint32_t, const Placement&, std::uint32_t) { goes_on = true; });
      if (!out_.reached[s] || goes_on || target_.complete(out_.states[s])) continue;
      if (out_.states[s].count() > most) {
        most = out_.states[s].count();
        best = s;
      }
    }
    return best;
  }

  const TargetBricks& target_;
  Policy& out_;
  Rank rank_;
  std::vector<bool> hopeful_;
};

/// They are drawn by chance, but an order's number decides all of it: each run has the same.
constexpr std::uint64_t kOrders = 64;            ///< of preference
constexpr std::size_t kMostEffort = 10'000'000;  ///< structures, for all of them

/// An order of preference by chance: the first half of them by what the column is alone, so that
/// it does not matter what stands about, the others by all that is seen.
std::uint64_t preference(std::uint64_t order, const Observation& seen, const Placement& placement) {
  std::uint64_t hash = mix(order);
  const auto add = [&](int value) { hash = mix(hash ^ static_cast<std::uint64_t>(value + 64)); };
  if (const auto top = column_top(seen)) {
    add(top->colour);
    add(top->level);
  }
  for (const int value : {placement.at.du, placement.at.dv, placement.at.z}) add(value);
  add(placement.colour);
  if (order >= kOrders / 2) {
    for (const std::uint8_t cell : seen.cells) add(cell);
    add(seen.side ? static_cast<int>(*seen.side) : -1);
  }
  return hash;
}

}  // namespace

PlacementKind kind_of(const Placement& placement) {
  if (placement.at.du == 1) return PlacementKind::extend;
  return placement.at.dv == 0 ? PlacementKind::raise : PlacementKind::beside;
}

Policy explore(const TargetStates& target, const Abilities& robot,
               const std::vector<ApproachSide>& sides, const PolicyScope& scope,
               const PolicyLimits& limits) {
  Sight sight(target, robot);
  const OpenBricks open = [&](const BrickSet& state) { return target.open(state); };
  return explore(target, open, sight, robot, sides, scope, limits);
}

/// Also used for structures whose order comes from elsewhere than rules (lib/assembly).
Policy explore(const TargetBricks& target, const OpenBricks& open, Sight& sight,
               const Abilities& robot, const std::vector<ApproachSide>& sides,
               const PolicyScope& scope, const PolicyLimits& limits) {
  assert(!sides.empty());
  Policy out;
  Explorer(target, open, sight, robot, sides, scope, limits, out).explore();
  if (out.too_large) return out;
  out.allowed.resize(out.observations.size());
  for (const Situation& situation : out.situations) {
    for (const auto& [placement, to] : situation.placements) {
      out.allowed[situation.observation].insert(placement);
    }
  }
  return out;
}

bool withdraw(Policy& policy, const Withdrawal& withdrawal) {
  assert(withdrawal.observation < policy.allowed.size());
  if (policy.allowed[withdrawal.observation].erase(withdrawal.placement) == 0) return false;
  policy.withdrawn.push_back(withdrawal);
  return true;
}

/// The first pass tells whether any order of placements completes the structure at all; if
/// not, no preference helps.
void prune(const TargetBricks& target, Policy& policy, Pruning pruning) {
  assert(!policy.too_large);
  const Policy before = pruning == Pruning::search ? policy : Policy{};
  std::size_t unlimited = std::numeric_limits<std::size_t>::max();
  Pruner(target, policy).prune(unlimited);
  if (pruning == Pruning::at_once || policy.complete || policy.out_of_reach) return;
  std::size_t effort = kMostEffort;
  for (std::uint64_t order = 0; order < kOrders && effort >= policy.states.size(); ++order) {
    Policy tried = before;
    tried.complete = false;
    const auto rank = [order](const Observation& seen, const Placement& placement) {
      return preference(order, seen, placement);
    };
    Pruner(target, tried, rank).prune(effort);
    if (!tried.complete) continue;
    policy = std::move(tried);
    return;
  }
}

}  // namespace stig::compiler
