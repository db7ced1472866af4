// SPDX-License-Identifier: MIT
// When compile refuses a rule set: would other rules let the robot build the same structure?
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "compiler/compile.h"
#include "uses.h"

namespace stig::cli {

/// Adds that to the last error, or that no rules would do. `robot_file` as the user wrote it.
void note_other_rules(const RuleSet& rules, const CompiledRules& compiled, const Abilities& robot,
                      const std::optional<std::string>& robot_file, Diagnostics& diagnostics);

}  // namespace stig::cli
