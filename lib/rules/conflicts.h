// SPDX-License-Identifier: MIT
// Pairs of rules that match one neighbourhood: conflicts and repetitions. Used by
// rule_checks.cpp.
#pragma once

#include "base/diagnostic.h"
#include "rules/rule_set.h"

namespace stig::rules {

/// R301 for pairs that place different bricks, each pair once; R302 when the search
/// had to be given up.
void check_conflicts(const RuleSet& rules, Diagnostics& diagnostics);

/// R303 for rules that say what an earlier one says.
void check_repetitions(const RuleSet& rules, Diagnostics& diagnostics);

/// Where a rule is best pointed at: its name.
SourceRange rule_place(const Rule& rule);

}  // namespace stig::rules
