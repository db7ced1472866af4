// SPDX-License-Identifier: MIT
// Makes rules for the most promising of the colourings that were found, and chooses the best.
#pragma once

#include "synthesis/effort.h"
#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

struct MergingLimits {
  Allowance quick;  ///< so long more than a few solutions of each number of colours are merged
  Allowance many;   ///< for the choice between solutions
  Allowance whole;  ///< for making the best one better
};

/// Sets best and others of `result`; nothing when there are no solutions. `ready`: one that
/// has its rules already.
void choose_rules(const Target& target, const SynthesisOptions& options,
                  std::vector<Solution> solutions, std::optional<Solution> ready,
                  const MergingLimits& limits, const SynthesisHooks& hooks, Synthesis& result);

}  // namespace stig::synthesis
