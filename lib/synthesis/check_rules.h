// SPDX-License-Identifier: MIT
// Do these rules build the target in every order? The last word on what was made: the
// compiled rules themselves are asked at every local state of every site, in the file's
// own terms, whatever was merged, named or numbered on the way.
#pragma once

#include <optional>
#include <string>

#include "synthesis/clashes.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// What is wrong, in words; nothing when every order of events ends in the target.
std::optional<std::string> find_fault(const Schedule& schedule, const Colouring& colours,
                                      const RuleSet& rules);

}  // namespace stig::synthesis
