// SPDX-License-Identifier: MIT
// Random rule sets and views for laws; call inside rc::check.
#pragma once

#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig {

/// Both lattices, every kind of pattern and condition, one to six rules.
RuleSet random_rule_set();
/// A view that often matches: drawn from one orientation of one rule, then with a
/// few cells changed.
View random_view(const RuleSet& rules);

}  // namespace stig
