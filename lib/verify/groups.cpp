// SPDX-License-Identifier: MIT
// Where the order of neighbours does not settle a site, the bricks concerned are enumerated
// jointly. The size of such a group decides everything, since its fillings can number
// 2^size; so groups begin with single bricks and take in more only where a search with them
// gets farther. In the worst case all bricks of the stage end in one group, which is the
// exhaustive exploration of all orders.
#include "verify/groups.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <set>
#include <utility>

namespace stig::verify {
namespace {

/// The number of rounds bounds the time lost to intermediate sizes before the exhaustive
/// search gets what is left.
constexpr int kMostRounds = 12;  ///< of growing before a group is all of the stage

/// Bricks beside each other are in one group. Groups of different windows must not touch:
/// the claims of a certificate say nothing of two groups jointly (docs/proofs.md, condition
/// 4).
Groups touching(const StageModel& model, const std::set<std::uint32_t>& bricks) {
  const Neighbourhood& n = model.table().neighbours();
  Groups groups;
  std::set<std::uint32_t> left = bricks;
  while (!left.empty()) {
    std::vector<std::uint32_t> group{*left.begin()};
    left.erase(left.begin());
    for (std::size_t k = 0; k < group.size(); ++k) {
      for (int i = 0; i < n.size; ++i) {
        const Cell beside = model.at(group[k]) + n.offsets[static_cast<std::size_t>(i)];
        const auto found = left.find(model.number(beside));
        if (found == left.end()) continue;
        group.push_back(*found);
        left.erase(found);
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

bool touches_another_group(const StageModel& model, const Invariant& invariant, std::uint32_t brick,
                           std::uint32_t number) {
  const Neighbourhood& n = model.table().neighbours();
  for (int i = 0; i < n.size; ++i) {
    const std::uint32_t beside =
        model.number(model.at(brick) + n.offsets[static_cast<std::size_t>(i)]);
    if (beside >= model.bricks()) continue;
    const std::uint32_t window = invariant.group_of[beside];
    if (window != Invariant::kNoWindow && window != number) return true;
  }
  return false;
}

}  // namespace

std::optional<Groups> grown(const StageModel& model, const Groups& groups,
                            const std::vector<LocalFailure>& failures, int round) {
  assert(round >= 0);
  std::set<std::uint32_t> bricks;
  for (const auto& group : groups) bricks.insert(group.begin(), group.end());
  const std::size_t had = bricks.size();
  const auto take = [&](std::uint32_t brick) {
    if (brick < model.bricks()) bricks.insert(brick);
  };
  StageSite site;
  for (const LocalFailure& failure : failures) {
    take(failure.site);
    // A brick alone at first: its window takes in what it needs.
    if (round == 0 && failure.site < model.bricks()) continue;
    model.look(failure.site, site);
    for (Mask left = failure.seen & site.bricks; left != 0; left &= left - 1) {
      take(site.brick[static_cast<std::size_t>(std::countr_zero(left))]);
    }
  }
  // Nothing new was concerned, so growing step by step has come to its end: all bricks are
  // taken.
  const bool all = bricks.size() == had || round >= kMostRounds;
  if (bricks.size() > kMostGroup || (all && model.bricks() > kMostGroup)) return std::nullopt;
  for (std::uint32_t b = 0; all && b < model.bricks(); ++b) bricks.insert(b);
  return touching(model, bricks);
}

void take_into_group(Invariant& invariant, std::uint32_t brick, std::uint32_t window) {
  assert(window < invariant.windows.size());
  assert(brick < invariant.before.size());
  std::vector<std::uint32_t>& group = invariant.windows[window].group;
  group.insert(std::lower_bound(group.begin(), group.end(), brick), brick);
  invariant.before[brick] = 0;
  invariant.group_of[brick] = window;
}

/// Each candidate is tried for real with a small budget of fillings. How many bricks the
/// failing filling has measures how far the search came; a search without failure beats
/// all.
std::uint32_t most_helpful(const StageModel& model, const Invariant& invariant,
                           std::uint32_t number, const Budget& budget) {
  constexpr std::uint64_t kAll = ~std::uint64_t{0};
  assert(number < invariant.windows.size());
  Budget little = budget;
  // 20 000 fillings suffice to compare candidates; the winner is then searched with the
  // whole budget.
  little.states = std::min<std::uint64_t>(little.states, 20'000);
  std::uint32_t best = StageModel::kNone;
  std::uint64_t farthest = 0;
  Invariant trial;  // the search of a window asks for nothing but `before`
  trial.before = invariant.before;
  for (const std::uint32_t brick : invariant.windows[number].context) {
    if (touches_another_group(model, invariant, brick, number)) continue;
    Window window;
    window.group = invariant.windows[number].group;
    window.group.push_back(brick);
    // The trial shares one `before` table and puts the entry back, since copying it for
    // each candidate would make the loop quadratic in the number of bricks.
    const Mask kept = std::exchange(trial.before[brick], 0);
    const auto failure = explore_window(model, trial, little, window);
    trial.before[brick] = kept;
    const std::uint64_t got = failure ? 1 + window.bricks_in(failure->filling) : kAll;
    if (got > farthest) {
      farthest = got;
      best = brick;
    }
  }
  return best;
}

}  // namespace stig::verify
