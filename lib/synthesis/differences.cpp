// SPDX-License-Identifier: MIT
// The clauses that clashes add, over variables "orbits a and b have the same colour". They
// hold for any number of colours, and what unit propagation derives from them does too; so
// pairs that must differ, and the cliques of such pairs, bound the number of colours from
// below before a solver has been asked.
#include "synthesis/differences.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

#include "base/hash.h"

namespace stig::synthesis {
namespace {

StateSet colours_of(const Schedule& schedule, int orbit) {
  return schedule.frame->orbits[static_cast<std::size_t>(orbit)].colours;
}

bool always_differ(const Schedule& schedule, int a, int b) {
  return (colours_of(schedule, a) & colours_of(schedule, b)).none();
}

bool always_equal(const Schedule& schedule, int a, int b) {
  if (a == b) return true;
  const StateSet colours = colours_of(schedule, a);
  return colours.is_single() && colours == colours_of(schedule, b);
}

/// Greedy: the orbit with the most differences first, then those that differ from all
/// taken. Finding the largest clique is NP-hard; a greedy one from each of the 64 orbits of
/// highest degree is good enough for a bound, and is the same on every run.
std::vector<int> greedy_clique(const std::vector<std::vector<int>>& differ) {
  std::vector<int> best;
  std::vector<int> by_degree;
  // Orbits without differences are in no clique of two and would only cost time.
  for (std::size_t i = 0; i < differ.size(); ++i) {
    if (!differ[i].empty()) by_degree.push_back(static_cast<int>(i));
  }
  const auto degree = [&](int i) { return differ[static_cast<std::size_t>(i)].size(); };
  std::stable_sort(by_degree.begin(), by_degree.end(),
                   [&](int a, int b) { return degree(a) > degree(b); });
  const std::size_t tries = std::min<std::size_t>(by_degree.size(), 64);
  for (std::size_t t = 0; t < tries; ++t) {
    std::vector<int> clique{by_degree[t]};
    std::vector<int> left = differ[static_cast<std::size_t>(by_degree[t])];
    while (!left.empty()) {
      const auto most = std::max_element(left.begin(), left.end(), [&](int a, int b) {
        return degree(a) != degree(b) ? degree(a) < degree(b) : a > b;
      });
      const int taken = *most;
      clique.push_back(taken);
      const std::vector<int>& of = differ[static_cast<std::size_t>(taken)];
      std::vector<int> rest;
      std::set_intersection(left.begin(), left.end(), of.begin(), of.end(),
                            std::back_inserter(rest));
      left = std::move(rest);
    }
    if (clique.size() > best.size()) best = std::move(clique);
  }
  return best;
}

}  // namespace

std::int32_t Differences::pair(int a, int b) {
  assert(a != b);
  if (a > b) std::swap(a, b);
  const std::uint64_t key = static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
  const auto [at, added] = pair_index_.try_emplace(key, static_cast<std::int32_t>(pairs_.size()));
  if (added) pairs_.emplace_back(a, b);
  return at->second;
}

bool Differences::add(const Clash& clash) {
  const Frame& frame = *schedule_->frame;
  const int from = schedule_->keys[static_cast<std::size_t>(clash.key)].site;
  const int to = frame.sites[static_cast<std::size_t>(clash.site)].orbit;
  DifferenceClause clause{clash, {}, -1};
  if (clash.intended && always_equal(*schedule_, from, to)) return false;
  std::uint64_t hash = clash.intended ? 1 : 0;
  // A pair that always differs makes the clause true, one that never does drops out of it.
  for (const auto& [a, b] : compared_orbits(*schedule_, clash)) {
    if (always_differ(*schedule_, a, b)) return false;
    if (always_equal(*schedule_, a, b)) continue;
    clause.differ.push_back(pair(a, b));
    hash = combine(hash, static_cast<std::uint64_t>(clause.differ.back()));
  }
  if (clash.intended && !always_differ(*schedule_, from, to)) {
    clause.equal = pair(from, to);
    hash = combine(hash, static_cast<std::uint64_t>(clause.equal) << 32);
  }
  // Equal hashes are taken for equal clauses. A collision would lose a clause, which the
  // next round of the search finds violated and cannot add, so it goes on until its effort
  // is spent, without an answer and never with a wrong one.
  if (!known_.try_emplace(hash, 0).second) return false;
  if (clause.differ.empty() && clause.equal < 0) hopeless_ = clash;
  clauses_.push_back(std::move(clause));
  return true;
}

/// States and keys of one brick are those of straight runs. There are few of them, and they
/// force most differences, which a solver would find one by one.
void Differences::add_single_bricks(std::size_t most, const Allowance& allowance) {
  const Frame& frame = *schedule_->frame;
  struct Seen {
    std::int32_t site;
    std::uint32_t mask;
  };
  std::array<std::array<std::vector<Seen>, kMaxNeighbours>, 2> seen;
  for (std::size_t s = 0; s < frame.sites.size(); ++s) {
    for (const std::uint32_t mask : schedule_->states.of(s)) {
      if (!std::has_single_bit(mask)) continue;
      seen[frame.sites[s].on_floor][static_cast<std::size_t>(std::countr_zero(mask))].push_back(
          {static_cast<std::int32_t>(s), mask});
    }
  }
  for (std::size_t k = 0; k < schedule_->keys.size(); ++k) {
    const Key& key = schedule_->keys[k];
    if (!std::has_single_bit(key.mask)) continue;
    if (allowance.out_of_time()) return;
    const bool on_floor = frame.sites[static_cast<std::size_t>(key.site)].on_floor;
    for (std::size_t g = 0; g < frame.group.size(); ++g) {
      const std::uint32_t mask = turned(key.mask, frame.group[g]);
      for (const Seen& state : seen[on_floor][static_cast<std::size_t>(std::countr_zero(mask))]) {
        if (clauses_.size() >= most) return;
        const Site& site = frame.sites[static_cast<std::size_t>(state.site)];
        add({static_cast<std::int32_t>(k), static_cast<std::int32_t>(g), state.site, mask,
             schedule_->intended(site, mask)});
      }
    }
  }
}

/// Unit propagation over pairs: O(literals), by counting for each clause the literals that
/// are not false yet.
std::vector<bool> Differences::forced_differences() const {
  std::vector<bool> differ(pairs_.size(), false), equal(pairs_.size(), false);
  std::vector<std::vector<std::int32_t>> uses(pairs_.size());
  std::vector<std::size_t> open(clauses_.size());  // literals not yet false
  std::vector<std::int32_t> queue;                 // pairs that were decided
  const auto settle = [&](std::int32_t pair, bool is_equal) {
    const auto p = static_cast<std::size_t>(pair);
    if (differ[p] || equal[p]) return;
    (is_equal ? equal : differ)[p] = true;
    queue.push_back(pair);
  };
  /// The one literal of a clause that is left decides its pair.
  const auto settle_last = [&](const DifferenceClause& clause) {
    for (const std::int32_t p : clause.differ) {
      if (!equal[static_cast<std::size_t>(p)]) settle(p, false);
    }
    if (clause.equal >= 0 && !differ[static_cast<std::size_t>(clause.equal)]) {
      settle(clause.equal, true);
    }
  };
  for (std::size_t c = 0; c < clauses_.size(); ++c) {
    for (const std::int32_t p : clauses_[c].differ) {
      uses[static_cast<std::size_t>(p)].push_back(static_cast<std::int32_t>(c));
    }
    if (clauses_[c].equal >= 0) {
      uses[static_cast<std::size_t>(clauses_[c].equal)].push_back(static_cast<std::int32_t>(c));
    }
    open[c] = clauses_[c].differ.size() + (clauses_[c].equal >= 0 ? 1 : 0);
    if (open[c] == 1) settle_last(clauses_[c]);
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::int32_t pair = queue[next];
    for (const std::int32_t c : uses[static_cast<std::size_t>(pair)]) {
      const DifferenceClause& clause = clauses_[static_cast<std::size_t>(c)];
      const bool in_equal = clause.equal == pair;
      const bool false_now =
          in_equal ? differ[static_cast<std::size_t>(pair)] : equal[static_cast<std::size_t>(pair)];
      if (false_now && --open[static_cast<std::size_t>(c)] == 1) settle_last(clause);
    }
  }
  return differ;
}

std::vector<int> Differences::clique() const {
  const std::vector<bool> forced = forced_differences();
  std::vector<std::vector<int>> differ(schedule_->frame->orbits.size());
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!forced[p]) continue;
    differ[static_cast<std::size_t>(pairs_[p].first)].push_back(pairs_[p].second);
    differ[static_cast<std::size_t>(pairs_[p].second)].push_back(pairs_[p].first);
  }
  for (std::vector<int>& of : differ) std::sort(of.begin(), of.end());
  return greedy_clique(differ);
}

}  // namespace stig::synthesis
