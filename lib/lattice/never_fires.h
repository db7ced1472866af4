// SPDX-License-Identifier: MIT
// Rules that no order of events ever fires, as far as this is cheap to know.
//
// More is granted than can happen: each cell may be empty or have any of the colours that
// some rule could place there, whatever its neighbours have. Bricks are added to these sets
// until no rule adds any more. What a rule asks for and this does not hold, no order of events
// builds. Where growth has no end that is soon met, only the colours are left to go by, as in
// the firing graph; and of a rule that could fire by all this, nothing is said.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "lattice/box.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// Looks at a rule's drawing in one orientation at one site; fractions of a second in all.
inline constexpr std::uint64_t kLooksForUse = 4'000'000;

/// Rules, rising, of which it is proved in this box, or in unbounded space.
std::vector<std::uint32_t> rules_that_never_fire(const RuleSet& rules,
                                                 const std::optional<Box>& box,
                                                 std::uint64_t most_looks = kLooksForUse);

/// Reports them (R318), in the file's own box. The set must have passed check_rule_set.
void check_rules_fire(const RuleSet& rules, Diagnostics& diagnostics);

}  // namespace stig::lattice
