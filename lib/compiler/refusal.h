// SPDX-License-Identifier: MIT
// Why there is no complete policy, said so that the author of the rules can act on it.
#pragma once

#include "compiler/compile.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// Before a policy is looked for: reports a brick that the start alone keeps robots from, whatever
/// else stands, since nothing of the start goes away. Is there one?
bool report_shut_in(const RuleSet& rules, const Abilities& robot, CompiledRules& compiled,
                    Diagnostics& diagnostics);

/// Reports one diagnostic for a policy that is not complete, and the drawings that go with it.
void explain_refusal(const RuleSet& rules, const Abilities& robot, CompiledRules& compiled,
                     Diagnostics& diagnostics);

}  // namespace stig::compiler
