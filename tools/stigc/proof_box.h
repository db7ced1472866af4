// SPDX-License-Identifier: MIT
// The world that verify and certify are asked about.
#pragma once

#include <optional>

#include "options.h"
#include "rules/rule_set.h"

namespace stig {

/// The box of the command line, else the file's; none: unbounded space.
std::optional<BoxSpec> meant_box(const RuleSet& rules, const std::optional<BoxOption>& box,
                                 bool periodic);

}  // namespace stig
