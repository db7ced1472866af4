// SPDX-License-Identifier: MIT
// Bricks that get one colour from the outset, so that the solver has few to find.
//
// In an order that begins with some rows in the middle and goes on row by row beside them
// (Liking::Spine), the rows beside have no end of their own to find: a brick comes wherever one
// stands before it, unless that is of the last row. How the rows are counted is up to the texture.
//
// Repeated: each row repeats three colours along itself, which say which row it is.
//
// Swept: one colour for all rows, but for two lines of others. The last bricks of all rows have one
// of their own, so each row ends where the one before it does. From a brick of the spine a line
// goes aslant, one brick a row, to where rows begin: the row that begins with it is the last.
//
// A plate, the spine s, rows swept from the left, the lines e and a:
//
//     a . . . . e
//     . a . . . e
//     . . a . . e
//     s s s s s s
//
// The swept texture takes three colours for rows of any number and length, and its rules are the
// same for all of them, but rows may be no longer than the spine.
#pragma once

#include <cstdint>
#include <vector>

#include "assembly/sequence.h"
#include "assembly/uses.h"

namespace stig::assembly {

/// By brick, the first of those that have its colour.
using Texture = std::vector<std::uint32_t>;

/// Every brick by itself.
Texture no_texture(std::size_t bricks);
/// The texture of rows beside a spine, swept where the liking is, or of a plate that is counted;
/// otherwise every brick is by itself.
Texture texture_of(const TargetBricks& target, const Liking& liking);

}  // namespace stig::assembly
