// SPDX-License-Identifier: MIT
// Long stretches of slices that are all alike, as a proof that so many colours do not do.
//
// A slice has the bricks of one x, or of one y. Take an order of work of robots, and a cut between
// two slices of the stretch, A and then B, with the start in A or before. The order puts the bricks
// of A and B one after the other: some of these, each with its colour. What is put before the cut
// sees no farther than B, and what is put behind it no farther than A. Those that come after the
// last of the other slice are not seen across the cut, so the *crossing* is what comes before them.
//
//     If the crossings at two cuts p < q are the same, there are no such rules.
//
// For then what was put before q, and what was put behind p moved along by q - p, fit together:
// each brick sees what it saw, and the rules lead to more bricks than there are. So the cuts on one
// side of the start are no more than there can be crossings. A brick comes after the one it stands
// on (Obstruction::covered), so with m bricks of a slice in piles of h1, h2 … bricks, and k
// colours, crossings that end in A number
//
//     sum over j < m of  m! / (h1! h2! …) · d(j) · C(m - 1 + j, j) · k^(m + j)
//
// where d(j) says in how many orders j bricks of the piles of B can come; and as many end in B.
#pragma once

#include <cstdint>
#include <optional>

#include "assembly/uses.h"
#include "compiler/target_bricks.h"

namespace stig::assembly {

struct Stretch {
  bool along_x = true;
  int first = 0, last = 0;          ///< slices of it, as coordinates
  std::size_t bricks_of_slice = 0;  ///< in each
  std::uint64_t crossings = 0;      ///< at most
};

/// One with more cuts on a side of the start than there can be crossings, wherever the start is, or
/// where it is given. The start stands on the floor.
std::optional<Stretch> stretch_too_long(const TargetBricks& target,
                                        std::optional<std::uint32_t> start, int colours);

}  // namespace stig::assembly
