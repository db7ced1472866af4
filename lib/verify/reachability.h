// SPDX-License-Identifier: MIT
// Can an agent that walks through empty cells get to every site in time?
//
// While q is empty, everything that is always after q is empty too. So q can be reached if
// a chain of bricks, each after the one before it and beside it, leads from q to a cell
// beside the outside. Where there is no such chain, an order is looked for in which q is
// really cut off. Moves are to any of the neighbours (26 or 20).
#pragma once

#include "verify/findings.h"
#include "verify/uses.h"

namespace stig::verify {

/// Fills in walled_in and maybe_walled_in of a proved set.
void find_walled_in(const RuleSet& rules, const VerifyOptions& options, const VerifyResult& result,
                    const Budget& budget, Findings& findings);

}  // namespace stig::verify
