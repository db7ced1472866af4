// SPDX-License-Identifier: MIT
// Rules as robots follow them that work from some of the four sides.
//
// A robot has no compass: it takes a rule as it sees it from where it stands. A rule as written is
// that of a robot at +x; under a symmetry its turn by 90° is the same rule for a robot at +y, and
// so on. Where nobody works from a side, the turns to that side are nobody's.
#pragma once

#include <string>
#include <vector>

#include "rules/rule_set.h"

namespace stig::rules {

/// The rules in those orientations that turn +x to one of the sides ("+x" "-x" "+y" "-y"), each
/// as a rule of its own, without symmetry. Unchanged where there is nothing to leave out: all four
/// sides, no side, no symmetry, or the hexagonal lattice, which has no sides.
RuleSet worked_from(RuleSet rules, const std::vector<std::string>& sides);

/// These sides or, if there are none, those that the file names; none: nobody says.
const std::vector<std::string>& own_sides(const RuleSet& rules,
                                          const std::vector<std::string>& sides);

/// The rules worked from own_sides().
RuleSet worked_from_own(RuleSet rules, const std::vector<std::string>& sides);

}  // namespace stig::rules
