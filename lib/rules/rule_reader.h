// SPDX-License-Identifier: MIT
// Reading a rule set: file -> YAML nodes with ranges -> RuleSet, every problem
// reported. Safe for hostile input: size, depth, nodes and aliases are bounded.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "rules/rule_set.h"

namespace stig::rules {

/// Largest rule set file read, in bytes.
inline constexpr std::size_t kMaxRuleFileBytes = std::size_t{1} << 20;

/// The rule set, or nothing when an error was reported (warnings alone do not
/// stop it). Includes the static checks of rule_checks.h.
std::optional<RuleSet> read_rule_set(SourceRef source, Diagnostics& diagnostics);

/// Reads the file first; a file that cannot be read is a diagnostic too.
std::optional<RuleSet> read_rule_set_file(const std::string& path, Diagnostics& diagnostics);

}  // namespace stig::rules
