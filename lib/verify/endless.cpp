// SPDX-License-Identifier: MIT
// Looks for a period in the last deposits of a run and checks the two conditions under
// which docs/proofs.md, "Growth without end", proves that the growth never stops: what the
// last repetition sees is newer than the second repetition, and no rule it uses meets a
// bound on its height. Periods are tried from 1 upwards, so the shortest is reported. The
// cost is O(longest period x deposits) comparisons in the worst case, and far less where
// deposits differ at once.
#include "verify/endless.h"

#include <algorithm>

#include "rules/site_condition.h"

namespace stig::verify {
namespace {

constexpr std::size_t kLongestPeriod = 1000;
/// The proof (docs/proofs.md) asks for three. A fourth leaves room for a first one that the
/// start still influenced.
constexpr std::size_t kFewestRepetitions = 4;

/// How far along the step a cell lies, in units of the step's squared length.
std::int64_t along(Offset step, Cell cell) {
  return std::int64_t{step.x} * cell.x + std::int64_t{step.y} * cell.y +
         std::int64_t{step.z} * cell.z;
}

/// The same rule in the same orientation: equal colours and sites are not enough, since
/// another rule could be one that a later height forbids.
bool repeats(const Deposit& a, const Deposit& b, Offset step) {
  return b.match == a.match && b.colour == a.colour && b.site - a.site == step;
}

/// Do the rules that fire go on firing however far they are carried?
bool heights_allow(const RuleSet& rules, const std::vector<Deposit>& run, std::size_t from,
                   Offset step) {
  if (step.z == 0) return true;
  if (rules.floor && step.z < 0) return false;
  // Where the first rule that matches acts, one that begins to match higher up takes over.
  const bool bounds = std::any_of(rules.rules.begin(), rules.rules.end(), [](const Rule& rule) {
    return !allows_every_height(site_condition(rule));
  });
  if (rules.conflicts == Conflicts::first && bounds) return false;
  for (std::size_t i = from; i < run.size(); ++i) {
    const SiteCondition where = site_condition(rules.rules[run[i].match.rule]);
    if (!allows_for_ever(where, step.z > 0)) return false;
    if (rules.floor && run[i].site.z < 1) return false;  // it sees the floor, later ones will not
  }
  return true;
}

}  // namespace

std::optional<Repetition> find_repetition(const RuleSet& rules,
                                          const std::vector<PlacedBrick>& before,
                                          const std::vector<Deposit>& run) {
  const std::size_t n = run.size();
  const std::size_t longest = std::min(kLongestPeriod, n / kFewestRepetitions);
  for (std::size_t period = 1; period <= longest; ++period) {
    const Offset step = run[n - 1].site - run[n - 1 - period].site;
    if (step == Offset{}) continue;
    // The deposits from `first` on repeat those a period before them; they are followed
    // backwards as far as that holds.
    std::size_t first = n - 1;  // of the deposits that repeat the one a period before
    while (first > period && repeats(run[first - 1 - period], run[first - 1], step)) --first;
    if (n - first < (kFewestRepetitions - 1) * period) continue;
    // Whole repetitions, counted from the end; all before the second is `old`.
    const std::size_t repetitions = (n - first) / period;
    const std::size_t old_end = n - (repetitions - 1) * period;
    std::int64_t farthest = INT64_MIN;
    for (const PlacedBrick& brick : before) farthest = std::max(farthest, along(step, brick.at));
    for (std::size_t i = 0; i < old_end; ++i) {
      farthest = std::max(farthest, along(step, run[i].site));
    }
    // The neighbours of a site lie at most |x| + |y| + |z| of the step to either side. A
    // neighbour's offset has no component larger than 1, so f(neighbour) differs from
    // f(site) by this at most. The estimate may reject growth that is periodic; it never
    // accepts other growth.
    const std::int64_t reach = std::int64_t{std::abs(step.x)} + std::abs(step.y) + std::abs(step.z);
    std::int64_t nearest = INT64_MAX;
    for (std::size_t i = n - period; i < n; ++i) {
      nearest = std::min(nearest, along(step, run[i].site));
    }
    if (nearest - reach <= farthest) continue;
    if (!heights_allow(rules, run, n - period, step)) continue;
    return Repetition{period, step};
  }
  return std::nullopt;
}

}  // namespace stig::verify
