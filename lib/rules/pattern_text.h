// SPDX-License-Identifier: MIT
// A structure as drawn in a file; patterns and views are in rule_printer.h.
#pragma once

#include <string>
#include <vector>

#include "rules/rule_set.h"

namespace stig {

/// Slices from the top down, parted by ---, rows y falling; the bounding box of the
/// bricks, which must not be empty.
std::string draw_structure(const RuleSet& rules, const std::vector<PlacedBrick>& bricks);

}  // namespace stig
