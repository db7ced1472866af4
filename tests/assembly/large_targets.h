// SPDX-License-Identifier: MIT
// Large targets by size, such as a user might draw, for benchmarks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/uses.h"
#include "synthesis/target.h"

namespace stig {

/// The walls of a maze of one level with one way in and one way from each place to each other; the
/// smallest square one of so many bricks or more. Corridors are `corridor` bricks wide.
Target maze_target(std::size_t bricks, int corridor, std::uint64_t seed);

/// Lots of 5×5 bricks, each paved, with a house of up to 3×3 columns and two levels upon it: the
/// smallest square town of so many bricks or more.
Target paved_town_target(std::size_t bricks, std::uint64_t seed);

/// Rows of houses of one to three levels, wall to wall, 3 bricks wide each and one deep, a brick
/// between any two, and a wall that the rows begin at: the smallest of so many bricks or more with
/// as many rows as houses in each. Robots have room between rows.
Target terraced_town_target(std::size_t bricks, std::uint64_t seed);

}  // namespace stig
