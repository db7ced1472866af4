// SPDX-License-Identifier: MIT
// Static checks: what is wrong with a rule set whatever it is run on (diagnostics
// R3xx). Nothing here runs the rules.
//
// A conflict is a neighbourhood, drawn in a note, that two rules match and in which
// they place different bricks. The search is exact: allowed states are intersected
// cell by cell, heights too, and counts are decided together by dynamic
// programming. With a floor two kinds of neighbourhood exist: the whole slice below
// is floor (a site at z = 0) or no cell is. Whether the rules can ever build such a
// neighbourhood is not asked; that is a matter for verification.
#pragma once

#include "base/diagnostic.h"
#include "rules/rule_set.h"

namespace stig::rules {

enum class CheckScope : std::uint8_t {
  all,
  certain,  ///< the set lacks parts that were wrong: nothing about what is missing
};

/// Reports every R301 to R316 but R313, which only the reader can see.
void check_rule_set(const RuleSet& rules, CheckScope scope, Diagnostics& diagnostics);

}  // namespace stig::rules
