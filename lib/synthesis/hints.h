// SPDX-License-Identifier: MIT
// Colours for a solver to start from.
#pragma once

#include "synthesis/clashes.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// What a solver may start from. Colours at random are mostly free of clashes at once,
/// regular ones make for fewer different keys, hence fewer rules.
enum class Hint : std::uint8_t { random, distance, depth, uniform };

/// Colours 1..k for every orbit.
Colouring hint_of(const Frame& frame, Hint hint, int k);

}  // namespace stig::synthesis
