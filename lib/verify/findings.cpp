// SPDX-License-Identifier: MIT
// What `stigc verify` reports beyond the verdict. Each item is either proved or counted as
// open: rules that never fire and redundant rules are theorems, `untried` and
// `maybe_walled_in` say of how many nothing is known. All searches share one budget, apart
// from the verdict's, so that a proof is not lost to what was only asked besides.
#include "verify/findings.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "lattice/firing_graph.h"
#include "lattice/never_fires.h"
#include "lattice/world.h"
#include "verify/reachability.h"
#include "verify/repair.h"
#include "verify/rule_use.h"

namespace stig::verify {
namespace {

/// A limit that does not depend on the budget keeps reports of large generated sets short.
constexpr std::size_t kMostRedundancyTrials = 200;

RuleSet without(const RuleSet& rules, std::size_t rule) {
  RuleSet fewer = rules;
  fewer.rules.erase(fewer.rules.begin() + static_cast<std::ptrdiff_t>(rule));
  return fewer;
}

/// A set without its last rule of some stage would have fewer stages. Then the numbers of
/// the stages that follow would shift, and the smaller set would be another program.
bool has_same_stages(const RuleSet& a, const RuleSet& b) {
  return a.stage_count() == b.stage_count();
}

void find_redundant(const RuleSet& rules, const VerifyOptions& options, const VerifyResult& result,
                    const Budget& budget, Findings& findings) {
  for (std::uint32_t r = 0; r < rules.rules.size(); ++r) {
    // A rule that never fires can be left out of course; it is listed as dead already.
    if (std::binary_search(findings.dead.begin(), findings.dead.end(), r)) continue;
    // Each trial costs about what the proof did.
    if (r >= kMostRedundancyTrials || budget.work_left() < result.work || budget.spent()) {
      ++findings.untried;
      continue;
    }
    const RuleSet fewer = without(rules, r);
    if (fewer.rules.empty() || !has_same_stages(fewer, rules)) continue;
    const VerifyResult trial = verify_within(fewer, options, budget);
    if (trial.verdict == ProofVerdict::proved && *trial.structure == *result.structure) {
      findings.redundant.push_back(r);
    } else if (trial.verdict == ProofVerdict::unknown && budget.spent()) {
      ++findings.untried;
    }
  }
}

/// All open sites at once, as far as they do not close each other; then again. The rounds
/// are a bound for ideal agents: nobody walks or waits. Sites are taken in the order in
/// which they opened, so the numbers are a property of the rule set and not of a seed. In a
/// proved set any choice of matches ends alike, hence the first match.
Parallelism parallelism_of(const RuleSet& rules, const std::optional<Box>& box) {
  Parallelism out;
  const RuleTable table(rules);
  LatticeWorld world(table, rules.start, box);
  do {
    std::vector<Cell> open = world.enabled_sites();
    while (!open.empty() && !world.stage_spent()) {
      std::uint64_t placed = 0;
      std::vector<Cell> next;
      for (const Cell site : open) {
        if (world.stage_spent() || world.at(site) != kEmpty) continue;
        const View view = world.view(site);
        std::vector<Match> matches;
        table.matches(view, site.z, world.stage(), matches);
        if (matches.empty()) continue;
        world.deposit(site, table.place(matches.front().rule),
                      [&](Cell beside, const View&) { next.push_back(beside); });
        ++placed;
      }
      out.rounds.push_back(placed);
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      std::erase_if(next, [&](Cell site) {
        return world.at(site) != kEmpty || !table.enabled(world.view(site), site.z, world.stage());
      });
      open = std::move(next);
    }
  } while (world.next_stage());
  return out;
}

void find_levels(const RuleSet& rules, Findings& findings) {
  findings.levels.assign(rules.rules.size(), std::nullopt);
  if (!firing_graph_problem(rules).empty()) return;
  const FiringGraph graph = firing_graph(rules);
  for (std::size_t r = 0; r < graph.nodes.size(); ++r) {
    findings.levels[r] = graph.nodes[r].level;
    if (graph.nodes[r].level) {
      findings.level_count = std::max(findings.level_count, *graph.nodes[r].level + 1);
    }
  }
}

}  // namespace

/// The widest round tells how many agents could be of use at the same time.
std::uint64_t Parallelism::widest() const {
  return rounds.empty() ? 0 : *std::max_element(rounds.begin(), rounds.end());
}

double Parallelism::mean() const {
  std::uint64_t bricks = 0;
  for (const std::uint64_t round : rounds) bricks += round;
  return rounds.empty() ? 0 : static_cast<double>(bricks) / static_cast<double>(rounds.size());
}

Findings find_more(const RuleSet& rules, const VerifyOptions& options, const VerifyResult& result,
                   const FindingOptions& limits) {
  Findings findings;
  std::uint64_t done = 0;
  const Budget budget{time_after(limits.seconds), options.states, options.stop, limits.work, &done};
  find_levels(rules, findings);
  findings.dead = rules_that_never_fire(rules, options.box);
  if (result.verdict == ProofVerdict::proved) {
    // Two proofs that a rule never fires, one from the certificate and one by
    // over-approximation of all cells' states (lattice/never_fires.h); neither contains the
    // other.
    const RuleUse use = use_of_rules(rules, options, result);
    std::vector<std::uint32_t> dead;
    std::set_union(findings.dead.begin(), findings.dead.end(), use.dead.begin(), use.dead.end(),
                   std::back_inserter(dead));
    findings.dead = std::move(dead);
    findings.blocking = use.blocking;
    findings.parallelism = parallelism_of(rules, options.box);
    find_walled_in(rules, options, result, budget, findings);
    find_redundant(rules, options, result, budget, findings);
  }
  // The rule of the decisive deposit closes the rival's site, or the other way round: the
  // plainest description of why a set is refuted.
  if (result.refutation) {
    const DivergingOrders& found = *result.refutation;
    findings.blocking.push_back({found.second[found.common].match.rule, found.rival.match.rule,
                                 found.second[found.common].site, found.rival.site});
    findings.repair = find_repair(rules, options, result, budget);
    findings.repair_cut_short = !findings.repair && budget.spent();
  }
  return findings;
}

}  // namespace stig::verify
