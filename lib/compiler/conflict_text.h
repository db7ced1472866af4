// SPDX-License-Identifier: MIT
// Whether a program is for one robot alone, and why, said so that the author of the rules can act
// on it.
#pragma once

#include "compiler/compile.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// In one line.
std::string conflict_text(const CompiledRules& compiled, const Conflict& conflict);

/// How many robots may work at once, and what that rests on: a line of a report.
std::string robots_text(const CompiledRules& compiled);

/// Reports the gravest, with drawings: as a refusal where more than one robot is to work, as a
/// warning where nobody said how many, and not at all where one works alone. Is it a refusal?
bool report_conflict(const RuleSet& rules, CompiledRules& compiled, Diagnostics& diagnostics);

}  // namespace stig::compiler
