// SPDX-License-Identifier: MIT
// Structures as text: slices from the top down, parted by lines of "---"; rows y
// falling, columns x rising, symbols parted by spaces, "." empty. The lowest,
// left-most drawn cell is (0, 0, 0). Hexagonal slices are drawn on the axial grid.
//
//   3 .          a column of two 3s with a 2 beside it, in x
//   ---
//   3 2
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.h"
#include "lattice/structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// How a row's symbols are told apart: by spaces, or as one character each ("##.#").
enum class RowForm { spaced, joined };

/// Symbols are those of `bricks`; errors (unknown symbol, ragged rows, slices of
/// different size) are reported. `corner` is the place of the lowest, left-most drawn
/// cell. Blank lines and lines that start with "//" are
/// passed over; of a blank line between rows of one slice a warning says so.
std::optional<Structure> read_structure_text(SourceRef source, Lattice lattice,
                                             const std::vector<Brick>& bricks,
                                             Diagnostics& diagnostics, Cell corner = {},
                                             RowForm form = RowForm::spaced);
/// For tests: digits 1-9 are colours 1-9; asserts on a malformed literal.
Structure structure_literal(std::string_view text, Lattice lattice = Lattice::cubic);

/// The drawing of the bounding box; reading it back gives the structure at the
/// origin. `bricks` gives the symbols; without them colours are numbers.
std::string print_structure(const Structure& structure, const std::vector<Brick>& bricks = {});

}  // namespace stig::lattice
