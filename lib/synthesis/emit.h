// SPDX-License-Identifier: MIT
// The rule set as a file shows it: bricks with symbols, rules with names that say what
// they look for, and what is to be expected of the set.
#pragma once

#include <string>

#include "synthesis/merge.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct Wording {
  std::string name;  ///< of the set; empty: none
  std::string title;
  std::string source;  ///< how it was made
};

/// `bricks`: those the target names; colours beyond get symbols, names and colours of
/// their own, and LEDs when there are at most four.
RuleSet make_rule_set(const Frame& frame, const Colouring& colours, int colour_count,
                      const std::vector<Brick>& bricks, const std::vector<MergedRule>& rules,
                      const Wording& wording);

/// "place 2 on 1 beside 3": what the bricks that a pattern asks for are to the site.
std::string name_of(const RuleSet& set, const MergedRule& rule);

}  // namespace stig::synthesis
