// SPDX-License-Identifier: MIT
// Symbols of states, and structures as drawn in a file; patterns and views are in
// rule_printer.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rules/rule_set.h"

namespace stig::rules {

/// The symbol that drawings of this set have for a set of states, if any.
std::optional<std::string> find_symbol(const RuleSet& rules, StateSet states);

/// Slices from the top down, parted by ---, rows y falling; the bounding box of the
/// bricks, which must not be empty.
std::string draw_structure(const RuleSet& rules, const std::vector<PlacedBrick>& bricks);

}  // namespace stig::rules
