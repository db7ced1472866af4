// SPDX-License-Identifier: MIT
// The shipped rule sets, for benchmarks.
#pragma once

#include <string>
#include <vector>

#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig::bench {

/// rulesets/NAME.yaml; ends the program with its diagnostics if it cannot be read.
RuleSet shipped(const std::string& name);

/// The sets of rulesets/, by name.
std::vector<std::string> shipped_names();

/// The most memory that the program has had so far.
double peak_megabytes();

}  // namespace stig::bench
