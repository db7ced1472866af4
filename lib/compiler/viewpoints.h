// SPDX-License-Identifier: MIT
// From where a robot looks at a column before it decides.
//
// The proof takes for granted that a robot has looked from every viewpoint (sight.h). Few of them
// tell what the decision asks for; this finds a few that lead to the same decision in every
// situation that can arise.
#pragma once

#include <vector>

#include "compiler/compile.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// Far ones first; never empty.
std::vector<Viewpoint> choose_viewpoints(const Abilities& robot, const CompiledRules& compiled);

}  // namespace stig::compiler
