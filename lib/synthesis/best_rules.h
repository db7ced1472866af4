// SPDX-License-Identifier: MIT
// Rules for the most promising of the colourings that were found, and the best of those.
#pragma once

#include "synthesis/effort.h"
#include "synthesis/synthesise.h"

namespace stig {

struct MergingLimits {
  Allowance quick;  ///< so long more than a few solutions of each number of colours are merged
  Allowance many;   ///< for the choice between solutions
  Allowance whole;  ///< for making the best one better
};

/// Sets best and others of `result`; nothing when there are no solutions.
void choose_rules(const Target& target, const SynthesisOptions& options,
                  std::vector<Solution> solutions, const MergingLimits& limits,
                  const SynthesisHooks& hooks, Synthesis& result);

}  // namespace stig
