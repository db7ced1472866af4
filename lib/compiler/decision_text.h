// SPDX-License-Identifier: MIT
// Decisions in words: a tree, and the same as a graph for Graphviz.
#pragma once

#include <string>

#include "compiler/decision.h"
#include "compiler/uses.h"
#include "rules/rule_set.h"

namespace stig::compiler {

/// "extend with Q2", "raise with Q3", "nothing".
std::string placement_text(const RuleSet& rules, const std::optional<Placement>& placement);
/// "the cell behind the column, level 1": a question without its mark.
std::string question_text(const Question& question);
/// "Q3", "0, 1", "empty, Q2".
std::string answers_text(const RuleSet& rules, const Question& question,
                         const std::vector<int>& answers);

/// One line a question or answer, two spaces a step, a newline at the end.
std::string decision_text(const RuleSet& rules, const DecisionNode& root);
std::string decision_dot(const RuleSet& rules, const DecisionNode& root);

}  // namespace stig::compiler
