// SPDX-License-Identifier: MIT
// What `stigc compile` prints of a rule set that a robot can build.
#pragma once

#include <string>

#include "compiler/compile.h"
#include "options.h"

namespace stig {

std::string compile_text(CompileTarget target, const RuleSet& rules, const Abilities& robot,
                         const CompiledRules& compiled);

}  // namespace stig
