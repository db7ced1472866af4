// SPDX-License-Identifier: MIT
// Bricks that get one colour from the outset, so that the solver has few to find.
//
// In an order that begins with two rows in the middle and goes on row by row beside them
// (Liking::Spine), the rows beside have no end of their own to find: a brick comes wherever one
// stands before it, unless that is of the last row. So they only count themselves, and for that it
// is enough that each repeats three colours along the row, which also say which way the row grows.
#pragma once

#include <cstdint>
#include <vector>

#include "assembly/sequence.h"

namespace stig {

/// By brick, the first of those that have its colour.
using Texture = std::vector<std::uint32_t>;

/// Every brick by itself.
Texture no_texture(std::size_t bricks);
/// Of rows beside a spine; without one, every brick by itself.
Texture texture_of(const TargetBricks& target, const Liking& liking);

}  // namespace stig
