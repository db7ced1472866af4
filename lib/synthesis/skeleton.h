// SPDX-License-Identifier: MIT
// A skeleton: the few bricks of a solid from which fills (fills.h) place all the others. Without
// rays one colour does; otherwise each ray and each fill has its own (skeleton_rules.h).
//
// It grows in rays from the start. A ray that rises or falls goes on by one rule, "behind is a
// brick of my colour", and ends by that rule's height: height counts without colours. So a cube
// takes five colours and five rules whatever its size: its diagonal, what is above and below it,
// and what is on either side. A level ray cannot count and
// is one brick long. Rays are chosen one by one, whichever lets the fills place the most.
#pragma once

#include "synthesis/fills.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct Ray {
  Colour from_colour = 0;  ///< of the brick it begins at; the same as `colour`: the start's
  Colour colour = 0;
  std::size_t along = 0;             ///< the neighbour that each brick is of the one before
  std::vector<std::int32_t> places;  ///< without the brick it begins at
};

/// Rays have colours from 2 on, 1 is kept for the first fill; a skeleton without rays is the start
/// alone, in that colour.
struct Skeleton {
  std::int32_t start = 0;
  std::vector<Ray> rays;
  std::vector<Fill> fills;  ///< enough of them, and none that can be spared
  int colours = 1;
};

struct SkeletonLimits {
  int colours = kMaxColours;
  Allowance allowance;
};

/// Nothing when none was found within the limits.
std::optional<Skeleton> find_skeleton(const SolidGrid& grid, std::int32_t start,
                                      const std::vector<Fill>& fills, const SkeletonLimits& limits);

}  // namespace stig::synthesis
