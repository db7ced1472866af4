// SPDX-License-Identifier: MIT
// Rule sets as the page's editor holds them, and what is said of them.
#pragma once

#include <optional>
#include <string>

#include "answers.h"
#include "base/diagnostic.h"
#include "rules/rule_set.h"

namespace stig::playground {

/// The question's `text`, a rule set that the page calls `name`.
SourceRef rules_source(const Json& question);
/// What it says; its diagnostics go into the answer. Nothing when it is invalid.
std::optional<RuleSet> read_rules_text(const Json& question, Json& out);

/// A file that comes with the question under a key: {name, text}. Null when it is not there.
SourceRef source_of(const Json& question, const char* key);

/// The question's `effort`, as --effort of verify and synth; 1 where it has none that makes sense.
double effort_of(const Json& question);

/// Adds `diagnostics` to an answer, as the program's --diagnostics json has them.
void add_diagnostics(const Diagnostics& diagnostics, Json& out);

}  // namespace stig::playground
