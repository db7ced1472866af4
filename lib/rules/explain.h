// SPDX-License-Identifier: MIT
// Why each rule fires or does not fire at a site, as data.
//
// For every rule all orientations of its symmetry group are tried on one view.
// A rule whose pattern matches nowhere is explained by its nearest orientation:
// the one in which the fewest cells disagree (the first of these). Conditions
// that no drawing shows (stage, height, counts) do not depend on the orientation
// and are listed beside the cells, so that all reasons are seen at once.
//
//   for (const RuleExplanation& rule : explain(rules, view, site.z, stage).rules)
//     if (!rule.fires) … rule.cells, rule.conditions …
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rules/rule_set.h"

namespace stig::rules {

/// A neighbour that disagrees with the pattern in the orientation reported.
struct FailedCell {
  Offset offset;    ///< from the site
  StateSet wanted;  ///< what the oriented pattern allows there
  State seen = kEmpty;
  bool operator==(const FailedCell&) const = default;
};

/// A condition that does not hold: `seen` is outside [min, max].
struct FailedCondition {
  std::string_view key;         ///< "stage", "height", … (site_condition.h), "count"
  std::size_t index = 0;        ///< count: index into Rule::counts
  int seen = 0;                 ///< the stage, the height, the number counted
  std::optional<int> min, max;  ///< not set: no bound on this side
  bool operator==(const FailedCondition&) const = default;
};

struct RuleExplanation {
  std::uint32_t rule = 0;         ///< index into RuleSet::rules
  bool fires = false;             ///< no failed cell and no failed condition
  std::uint32_t orientation = 0;  ///< the one that matches, or the nearest
  std::uint32_t orientations = 1;
  std::vector<FailedCell> cells;  ///< in neighbour order
  std::vector<FailedCondition> conditions;
};

struct Explanation {
  View view;
  std::int32_t height = 0;
  int stage = 1;
  std::vector<RuleExplanation> rules;  ///< one a rule, in the order of the file
};

/// `view` is what a site at height z sees (lattice/swarm.h view_at); stage >= 1.
Explanation explain(const RuleSet& rules, const View& view, std::int32_t z, int stage);

}  // namespace stig::rules
