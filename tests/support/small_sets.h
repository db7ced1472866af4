// SPDX-License-Identifier: MIT
// Rule sets as literals: the YAML text of a set, read as a user's file is.
#pragma once

#include <string>

#include "rules/rule_set.h"
#include "support/uses.h"

namespace stig {

/// Fails the test when the text is not a good rule set. `rules` is the text below
/// `rules:`; `head` stands before it. Bricks 1, 2 and 3, cubic, start one 1 at the
/// origin, unless the head says otherwise.
RuleSet small_set(const std::string& rules, const std::string& head = "");

/// One rule of small_set: place `brick` east of a `west`, all else open.
std::string east_of(const std::string& west, const std::string& brick,
                    const std::string& more = "");

}  // namespace stig
