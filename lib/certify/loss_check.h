// SPDX-License-Identifier: MIT
// The checker of what is said of lost bricks (verify/losses.h), without a line in common with those
// who say it. It holds that a list of structures is closed:
//
//   - the start is one that is reached, and every event from one that is reached leads to one that
//     is reached;
//   - what is left of one that is reached after the loss of a brick is listed, and so is all that
//     events make of what is listed;
//   - of what is listed only the end has no event left.
//
// Every event adds a brick, and the list is finite: so every order of events ends, after a loss as
// without one, and in that end.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/uses.h"
#include "rules/rule_set.h"

namespace stig::certify {

/// Each structure's bricks by cell.
struct LossClaim {
  const std::vector<PlacedBrick>& end;
  const std::vector<std::vector<PlacedBrick>>& reached;
  const std::vector<std::vector<PlacedBrick>>& after;  ///< after a loss alone
};

/// What does not hold, in a sentence, or nothing. The box has its origin; none: unbounded space.
/// `goes_on`, if given, is asked before each structure, of so many bricks; where it says no,
/// nothing holds.
std::string loss_refusal(const RuleSet& rules, const std::optional<BoxSpec>& box,
                         const LossClaim& claim,
                         const std::function<bool(std::size_t bricks)>& goes_on = {});

}  // namespace stig::certify
