// SPDX-License-Identifier: MIT
// The rule sets that the project ships, for tests.
#pragma once

#include <string>
#include <vector>

#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig {

/// Reads rulesets/<name>.yaml; a file with an error fails the test that asked.
RuleSet shipped(const std::string& name);
/// The names of all of them, sorted.
std::vector<std::string> shipped_names();

}  // namespace stig
