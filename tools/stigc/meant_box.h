// SPDX-License-Identifier: MIT
// The world that a command is asked about: the file's, unless the command line says otherwise.
#pragma once

#include <optional>
#include <string>

#include "options.h"
#include "rules/rule_set.h"
#include "uses.h"

namespace stig::cli {

/// The box of the command line, else the file's; none: unbounded space. `problem` becomes the words
/// of what is wrong with it.
std::optional<BoxSpec> meant_box(const RuleSet& rules, const WorldOptions& world,
                                 std::string& problem);

}  // namespace stig::cli
