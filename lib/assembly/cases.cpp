// SPDX-License-Identifier: MIT
// Observations of the walk are merged over states: what a robot sees there is all it can go by.
// Each unfinished state then asks that in some observation that can be made in it something is
// done. States with the same observations ask the same, which leaves far fewer conditions than
// states.
#include "assembly/cases.h"

#include <algorithm>
#include <cassert>

namespace stig::assembly {

namespace {

constexpr std::uint32_t kNoCase = ~std::uint32_t{0};

Case case_of(const Policy& policy, std::uint32_t observation) {
  const Observation& seen = policy.observations[observation];
  assert(seen.cells.size() <= kMostCells && seen.side);
  Case out;
  out.side = *seen.side;
  out.bricks.assign(seen.cells.size(), 0);
  for (std::size_t i = 0; i < seen.cells.size(); ++i) {
    // A cell may also be unseen: then it is in neither set, and no question may depend on it.
    out.empty[i] = seen.cells[i] == kSeenEmpty;
    out.filled[i] = seen.cells[i] > kSeenBrick;
    if (out.filled[i]) out.bricks[i] = static_cast<std::uint32_t>(seen.cells[i] - kSeenBrick - 1);
  }
  for (const Placement& placement : policy.allowed[observation]) {
    out.choices.push_back({placement.at, static_cast<std::uint32_t>(placement.colour - 1)});
  }
  return out;
}

}  // namespace

Cases cases_of(const CandidateOrder& candidate) {
  assert(candidate.walked);
  const Policy& policy = candidate.policy;
  Cases out;
  std::vector<std::uint32_t> number(policy.observations.size(), kNoCase);
  for (std::uint32_t s = 0; s < policy.states.size(); ++s) {
    // Only states that can occur once the walk is pruned count.
    if (!policy.reached[s]) continue;
    std::vector<WayOn> ways;
    for (std::size_t i = policy.first[s]; i < policy.first[s + 1]; ++i) {
      const std::uint32_t seen = policy.situations[i].observation;
      if (number[seen] == kNoCase) {
        number[seen] = static_cast<std::uint32_t>(out.cases.size());
        out.cases.push_back(case_of(policy, seen));
      }
      // An observation without work can never be the way on.
      if (!out.cases[number[seen]].choices.empty()) ways.push_back({number[seen]});
    }
    if (!candidate.target->complete(policy.states[s])) out.ways_on.push_back(std::move(ways));
  }
  std::sort(out.ways_on.begin(), out.ways_on.end());
  out.ways_on.erase(std::unique(out.ways_on.begin(), out.ways_on.end()), out.ways_on.end());
  return out;
}

}  // namespace stig::assembly
