// SPDX-License-Identifier: MIT
// Small random rule sets in small boxes, whose orders of events can all be tried.
#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "support/oracle.h"
#include "support/uses.h"

namespace stig {

/// World number `seed`: two colours, a box of up to 4×4×4, both lattices, exact, sparse and
/// wildcard patterns, heights, counts, symmetries, floors, periodic sides, stages.
RuleSet small_world(std::uint64_t seed);

/// The same with its rules dealt out to up to three stages, some of which are cut short, and
/// after them a stage that stacks bricks on all that stand, in one way only.
RuleSet staged_small_world(std::uint64_t seed);

/// Rules that fire in some order of events, as far as `most` structures show it.
std::set<std::uint32_t> rules_seen_to_fire(const RuleSet& rules, std::size_t most);

/// Every structure in which some order of events ends, stage after stage, by trying them
/// all in the set's own box (solid or periodic); nothing when more than `most` structures
/// are met. Knows the language's meaning and OracleMatcher, no engine. `last_stage`: the
/// structures at the end of an earlier stage; 0: of all.
std::optional<std::set<BrickMap>> all_ends(const RuleSet& rules, std::size_t most,
                                           int last_stage = 0);

}  // namespace stig
