// SPDX-License-Identifier: MIT
// Tables of rules as they were published: numbers around a site, and the brick that is placed
// there.
//
// Papers and the programs that follow them write a rule down as the exact states of all neighbours,
// 0 for an empty cell and k for brick k. Three forms are met:
//
//   matrices   three rows of nine entries, the slices above, level and below side by side, the site
//              as *; then "=> brick". Cubic; on the hexagonal lattice the same matrices, whose
//              third and seventh entries are no cells (Theraulaz & Bonabeau 1995, J. theor. Biol.
//              177, appendix).
//   slices     hexagonal: a line of 7, 6 and 7 entries for the slices above, level and below, then
//              "=> brick"
//   lines      hexagonal: the same 20 entries, the brick and its probability on one line, commas
//              between entries, as the public program BeeHiveSim keeps them
//
// Lines that begin with # or // are comments, and "step N" in one begins a stage. Symmetry and
// start are no part of these tables: who reads one says which symmetry is meant, and the start is
// one brick of the first kind.
#pragma once

#include <cstdint>
#include <optional>

#include "base/diagnostic.h"
#include "rules/rule_set.h"

namespace stig::rules {

enum class TableForm : std::uint8_t { matrices, slices, lines };

/// What a table does not say.
struct TableReading {
  std::optional<TableForm> form;  ///< left out: by the table's first line
  Lattice matrices_of = Lattice::cubic;
  Symmetry symmetry = Symmetry::rotations;
  bool inversion = false;
};

/// The rule set, named "table", bricks without colours; nothing when an error was reported (F420).
/// Comments are kept, those above the first rule at the front. The source may hold anything.
std::optional<RuleSet> read_published_table(SourceRef source, const TableReading& reading,
                                            Diagnostics& diagnostics);

}  // namespace stig::rules
