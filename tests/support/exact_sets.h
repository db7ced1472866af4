// SPDX-License-Identifier: MIT
// Rule sets of exact patterns read off a target and an order of placement: each
// placement gives the rule that shows all 26 neighbours as they are at that moment.
#pragma once

#include <vector>

#include "support/oracle.h"
#include "support/uses.h"

namespace stig {

/// Cells that the group maps to each other, about the cell (0, 0, 0).
std::vector<std::vector<Cell>> orbits_of(const BrickMap& target, Symmetry symmetry);

/// The start is the one cell of the first orbit. Orbits follow one after the other;
/// within an orbit cells come in any order, so each has one pattern for every subset
/// of its neighbours of the same orbit. Patterns that are turns of each other are one
/// rule. Cubic, no floor.
RuleSet exact_set(const BrickMap& target, const std::vector<std::vector<Cell>>& orbits,
                  Symmetry symmetry);

/// No two rules disagree on a pattern, none is empty all round, and every order of
/// events from the set's start ends in the target.
bool builds_exactly(const RuleSet& rules, const BrickMap& target);

}  // namespace stig
