// SPDX-License-Identifier: MIT
// Is there a neighbourhood that fulfils a drawing and conditions? Exact, with an
// example; used by the static checks.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rules/rule_set.h"
#include "rules/site_condition.h"

namespace stig::rules {

/// What one rule, or several at once, demand of a site.
struct Demand {
  Pattern pattern;
  SiteCondition where;
  std::vector<CountCondition> counts;
};
Demand demand_of(const Rule& rule);
Demand both(const Demand& a, const Demand& b);

/// A pattern as the orientation shows it.
Pattern turned(const Pattern& pattern, const Orientation& orientation, Lattice lattice);

enum class Answer : std::uint8_t { yes, no, unknown };

struct Example {
  View view;
  std::int32_t z = 0;
};

/// Elementary steps a search may still take; shared by many searches.
using Budget = std::int64_t;

/// Looks for a view that fulfils the demand in some stage, in a world of this set's colours, with
/// or without floor. `unknown` when the budget ends first.
Answer find_view(const RuleSet& rules, const Demand& demand, Example& example, Budget& budget);

/// Does a given view at height z fulfil the demand, in some stage?
bool fulfils(const Demand& demand, Lattice lattice, const View& view, std::int64_t z);

}  // namespace stig::rules
