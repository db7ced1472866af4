// SPDX-License-Identifier: MIT
// Growth that repeats itself: a proof that an order of events need never end.
//
// If the last deposits of a run repeat the ones before them, shifted by a step t, and
// again the ones before those, and what the last repetition sees is far from everything
// older than the second repetition (measured along t), then the next repetition sees
// exactly what the last one saw, shifted by t; and so for ever.
#pragma once

#include <optional>
#include <vector>

#include "lattice/swarm.h"
#include "verify/uses.h"

namespace stig::verify {

struct Repetition {
  std::uint64_t period = 0;  ///< deposits
  Offset step;               ///< not zero
};

/// Looks at the end of a run of one stage in unbounded space. `before`: all bricks there
/// were when the run began.
std::optional<Repetition> find_repetition(const RuleSet& rules,
                                          const std::vector<PlacedBrick>& before,
                                          const std::vector<Deposit>& run);

}  // namespace stig::verify
