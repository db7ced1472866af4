// SPDX-License-Identifier: MIT
// The rules of a skeleton and its fills.
#pragma once

#include "synthesis/presence_check.h"
#include "synthesis/skeleton.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct SkeletonRules {
  std::vector<MergedRule> rules;
  PlaceColours colours;
  int colour_count = 0;
  std::vector<std::int32_t> order;  ///< one in which the target grows
};

/// Rules that place different bricks are kept apart by a height or by some cell. Nothing when
/// they do not build the target in every order of events (presence_check.h).
std::optional<SkeletonRules> make_skeleton_rules(const SolidGrid& grid, const Skeleton& skeleton,
                                                 bool floor, const Allowance& allowance);

}  // namespace stig::synthesis
