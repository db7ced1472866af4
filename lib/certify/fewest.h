// SPDX-License-Identifier: MIT
// Does a formula say what it claims of colours? DRAT proofs show that a formula has no
// solution; this shows that every colouring of the claimed kind would be one.
//
// The claim is about a target, an order and k colours: there is no colouring with which
// the order's *exact rules* build the target in that order. The exact rules of a cell
// that is not of the start look for all its neighbours of lower rank, any of those of
// equal rank, and nothing else, in every orientation of the group about the vertical
// through the middle of the start. They build in the order when a rule acts at a cell
// only once its neighbours of lower rank are there, with the cell's colour, and nowhere
// outside the target. Cells that the group maps to each other have one colour, since what
// such rules build has the group's symmetry.
//
// Each clause stands behind a comment that gives its reason (synthesis/proof_files.h has
// the forms). Here it is derived again from the reason and the problem: for a clash, that
// the two structures it speaks of can really be reached, and that the rule of the one cell
// would act at the other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "certify/uses.h"

namespace stig::certify {

struct FewestReport {
  bool derived = false;
  std::string refusal;        ///< one sentence, with the clause's number
  std::uint64_t cells = 0;    ///< of the target
  int colours = 0;            ///< that do not do
  std::string order;          ///< its name, as given
  std::uint64_t clashes = 0;  ///< clauses about what looks alike
};

/// `problem`: the text of fewer.json; `cnf`: that of fewer.cnf.
FewestReport derive_formula(std::string_view problem, std::string_view cnf);

}  // namespace stig::certify
