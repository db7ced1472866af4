// SPDX-License-Identifier: MIT
// The rule set of a painted candidate: a rule for each brick, that asks for exactly what stands
// about its site when it is due, at its height where another level looks the same.
#pragma once

#include "assembly/colours.h"
#include "assembly/uses.h"
#include "synthesis/emit.h"

namespace stig::assembly {

/// `robots`: that the file says work at once; none: it does not say.
RuleSet rules_of(const Target& target, const CandidateOrder& candidate, const RuleView& view,
                 const std::vector<Colour>& colours, const std::vector<ApproachSide>& sides,
                 std::optional<int> robots, const Wording& wording);

}  // namespace stig::assembly
