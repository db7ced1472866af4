// SPDX-License-Identifier: MIT
// A straight run has to count its cells, and one row can only count in ones: a colour
// for each. With a second row beside it the two count in digits, and a few colours do.
// A scaffold is such a row, of cells that the target lacks and the user allows; it
// stays in the structure. Or it is a wall on a level run, whose top rises and falls: heights
// tell the rules where a slope ends, so that a colour does for each slope (by_skeleton.h).
#pragma once

#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct Scaffold {
  std::vector<Cell> cells;
  Target target;     ///< with the scaffold
  Synthesis result;  ///< of that
};

/// Cells of a solution that must all have different colours under its order.
std::vector<Cell> counting_cells(const Solution& solution, int named);

/// The longest straight row of the target's cells, in one of the directions of faces.
std::vector<Cell> longest_run(const Target& target);

/// The scaffold of at most `most` cells with which the fewest colours do, fewer than
/// `colours`; nothing when none helps. `run`: the cells that have to count. Each try takes a
/// share of `effort`: half of the rest as long as none has helped.
std::optional<Scaffold> find_scaffold(const Target& target, const std::vector<Cell>& run,
                                      std::size_t most, int colours,
                                      const SynthesisOptions& options, double effort,
                                      const SynthesisHooks& hooks);

}  // namespace stig::synthesis
