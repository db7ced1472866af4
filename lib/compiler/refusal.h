// SPDX-License-Identifier: MIT
// Why a policy is not complete, said so that the author of the rules can act on it.
#pragma once

#include "compiler/compile.h"

namespace stig {

/// Reports one diagnostic for a policy that is not complete, and the drawings that go with it.
void explain_refusal(const RuleSet& rules, const Abilities& robot, CompiledRules& compiled,
                     Diagnostics& diagnostics);

}  // namespace stig
