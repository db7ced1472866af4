// SPDX-License-Identifier: MIT
// Printing a rule set in the canonical file form: reading it back gives an equal
// RuleSet, and printing that gives the same bytes (laws held by tests).
#pragma once

#include <cstdint>
#include <string>

#include "rules/rule_set.h"

namespace stig::rules {

/// YAML text of format version 1, comments included. Sets of states that have no
/// symbol get one in the legend.
std::string print_rule_set(const RuleSet& rules);

/// 64-bit hash of what the set means: lattice, symmetry, bricks, start, rules,
/// stages, box; not of titles, comments, expectations or layout.
std::uint64_t rule_set_hash(const RuleSet& rules);

/// A pattern as drawn in a file: three slices side by side, one line a row.
std::string draw_pattern(const RuleSet& rules, const Pattern& pattern);
/// A view in the same form.
std::string draw_view(const RuleSet& rules, const View& view);
/// The symbol of one state or set, as a drawing shows it ("." "=" "?" "#" "3" "a");
/// sets without a symbol are written {1,2}.
std::string symbol_of(const RuleSet& rules, StateSet states);

}  // namespace stig::rules
