// SPDX-License-Identifier: MIT
// What would help when a target cannot be compiled. Nothing is suggested that was not
// tried: each remedy led to a rule set that passed every check.
#pragma once

#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// In words, as options of `stigc synth` where there is one; the best first. All tries
/// together take about as much effort as the options allow for one search.
std::vector<std::string> find_remedies(const Target& target, const SynthesisOptions& options,
                                       const Obstacle& obstacle, const SynthesisHooks& hooks);

}  // namespace stig::synthesis
