// SPDX-License-Identifier: MIT
// Chains of `before` that leave the surroundings of a site: two windings of a spiral, seen
// from between them, are ordered by all that lies in between.
#pragma once

#include <vector>

#include "verify/local_proof.h"
#include "verify/uses.h"

namespace stig::verify {

/// Looks for chains between bricks around the sites that failed. True: some were added to
/// invariant.far.
bool add_far_chains(const StageModel& model, const std::vector<LocalFailure>& failures,
                    Invariant& invariant);

/// Takes out chains with a step that `before` no longer has. True: there were some.
bool drop_broken_chains(const StageModel& model, Invariant& invariant);

}  // namespace stig::verify
