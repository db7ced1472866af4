// SPDX-License-Identifier: MIT
// Structures as text in files of their own: slices (structure_text.h) with a head that
// says what they do not, so that a file stands for itself.
//
//   // lattice: hexagonal
//   // lowest corner: 9 10 16      the place of the lowest, left-most drawn cell
//   // bricks: a b                 their symbols, in the order of their colours
//   a .
//   b b
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lattice/loaded_structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// A lattice and bricks that are given win over the head; another lattice there is a
/// diagnostic. Without either the lattice is cubic, the corner (0, 0, 0), and the bricks
/// are numbers when all symbols are, otherwise the symbols in order of appearance. Rows that are
/// one word each, such as "##.#", are then read a character a cell.
std::optional<LoadedStructure> read_text_file(const SourceRef& source,
                                              std::optional<Lattice> lattice,
                                              const std::vector<Brick>& bricks,
                                              Diagnostics& diagnostics);

/// Head and slices. Symbols that cannot be drawn with are replaced by numbers.
std::string print_text_file(const Structure& structure, const std::vector<Brick>& bricks);

}  // namespace stig::lattice
