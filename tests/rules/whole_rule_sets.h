// SPDX-License-Identifier: MIT
// Random rule sets that use everything a file can say; call inside rc::check.
#pragma once

#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig {

/// Free of errors, so that it can be printed and read back. Sets of states that its
/// drawings need have a legend entry.
RuleSet random_whole_rule_set();

}  // namespace stig
