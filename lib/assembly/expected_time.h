// SPDX-License-Identifier: MIT
// How long a build may take: an estimate from measured builds, no proof.
#pragma once

#include "assembly/uses.h"
#include "assembly/work.h"

namespace stig::assembly {

/// Seconds that one robot takes for a brick, from block to block: measured with the paper's robot
/// at the staircase (31 s) and at drawn targets (39 s), docs/acceptance.md.
inline constexpr double kSecondsOfBrick = 40;
/// Several robots take so much longer than if none was ever in another's way: two, three and four
/// at the stepped pyramid took 1.2, 1.4 and 1.1 times as long.
inline constexpr double kInEachOthersWay = 1.25;

/// Seconds for the work, of `robots` of which no more are at work at a time than sites are open.
/// Within a third of what was measured; how far blocks are away counts for nothing.
double expected_seconds(const std::vector<WorkStep>& work, int robots);

}  // namespace stig::assembly
