// SPDX-License-Identifier: MIT
// Plates whose bricks count in binary how far they go: rules for a plate of a few thousand bricks
// in four colours, without a search for most of them.
//
// From a corner, some rows count columns along x, each the number of the one before and one more,
// with the lowest digit in the outermost row and a border above the highest. A carry is seen as a
// digit that was one and is none, in the row below. When the highest digit carries, a line of a
// colour of its own, the end, goes aslant to the lowest row, and where it comes to the edge the
// plate ends. The same along y, and what is left goes row by row: a brick has the colour of the
// border where one of the border or the end stands before it, and the last of a row the end's.
//
//     # # # # # # # # # # # # # e
//     # # # # # # # # # # # # # e     0, 1 digits, # border, e end, s whatever the solver finds:
//     # # # # # # # # # # # # # e     numbers from which both counts begin
//     # # # # # # # # # # # # # e
//     . . . # # # # # # # # # # e
//     s s s . 1 1 1 1 e 0 0 0 0 #     (rows of a plate that is larger than drawn)
//     s s s . 0 0 1 1 0 e 0 0 0 #
//     s s s . 0 1 0 1 0 1 e 0 0 #
//
// Work is done from two sides, +x and +y. Both sides of the plate may be of any length that the
// digits hold, so rules grow as the logarithm of the plate.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assembly/span.h"
#include "assembly/uses.h"

namespace stig::assembly {

/// The colours that counting takes.
inline constexpr int kCountedColours = 4;

/// Rows that the target takes to count, the border among them; nothing where it is no full
/// rectangle of one level, or too narrow for them.
std::optional<int> rows_to_count(const TargetBricks& target);

/// When a brick comes, the first at 0: the corner in shells about the start, the rows that count
/// column by column, the rest row by row. `x`, `y`: of the target.
std::int64_t counted_turn(int rows, const Span& x, const Span& y, Cell cell);

/// By brick, the first of those that have its colour.
std::vector<std::uint32_t> counted_texture(const TargetBricks& target, int rows);

}  // namespace stig::assembly
