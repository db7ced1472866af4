// SPDX-License-Identifier: MIT
// Rules with heights: a skeleton of coloured rays, and fills for the rest (skeleton.h).
#pragma once

#include "synthesis/effort.h"
#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// The best of those that grow from the given start, or from the corners and the middle of the
/// target's bottom and top; nothing when none was found. Without a symmetry and given
/// colours, and for targets of several levels.
std::optional<Solution> solve_by_skeleton(const Target& target, const SynthesisOptions& options,
                                          const Allowance& allowance);

}  // namespace stig::synthesis
