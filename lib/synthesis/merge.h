// SPDX-License-Identifier: MIT
// From exact rules to few general ones.
//
// A pattern may let a cell be anything, any brick or one state, as long as every local
// view that it matches, in any orientation, is one where its brick belongs. Such
// patterns are grown from one exact rule at a time: demands are added, the most telling
// first (FOIL's gain: Quinlan 1990, "Learning logical definitions from relations"),
// until no other view matches; then those that turn out not to be needed are taken
// away; then what another pattern covers is left out.
//
// Patterns that place different bricks are kept apart by some cell, so that no
// neighbourhood whatever matches both: `stigc check` asks for that, too.
#pragma once

#include <optional>
#include <vector>

#include "synthesis/effort.h"
#include "synthesis/local_views.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct MergedRule {
  Pattern pattern;
  Colour place = 0;
  std::int32_t rank = 0;                          ///< the lowest of the exact rules that it covers
  std::optional<int> height_min{}, height_max{};  ///< of the site, inclusive
};

/// `restarts`: so many covers are made, each from the exact rules in another order, and
/// the smallest is kept. When the allowance is spent what is left stays exact.
std::vector<MergedRule> merge_rules(const Frame& frame, int colours,
                                    const std::vector<ExactRule>& exact,
                                    const std::vector<LocalView>& views, int restarts,
                                    const Allowance& allowance);

/// Without merging.
std::vector<MergedRule> as_patterns(const Frame& frame, const std::vector<ExactRule>& exact);

}  // namespace stig::synthesis
