// SPDX-License-Identifier: MIT
// Is a candidate coordinated: does every order of its events end alike? The verifier says so, of
// candidates that gave it no reason for doubt.
#pragma once

#include <cstdint>

#include "search/genome.h"
#include "search/trials.h"
#include "search/uses.h"

namespace stig::search {

/// How the question was answered. Files of results have the numbers.
enum class Coordination : std::uint8_t {
  not_asked = 0,    ///< the plan allows no proofs, or the run did not end
  other_ends = 1,   ///< a further order of the trials ended differently
  refuted = 2,      ///< by the verifier: two orders that end differently
  endless = 3,      ///< by the verifier: an order that goes on for ever
  undecided = 4,    ///< within the plan's steps
  certificate = 5,  ///< proved, each the verifier's method of that name
  components = 6,
  exhaustive = 7,
};
inline bool is_coordinated(Coordination how) { return how >= Coordination::certificate; }

/// `counts` and `trials` are those of the candidate; `work` is in the verifier's steps, 0: none.
/// The proof is about unbounded space.
Coordination coordination_of(const Genome& genome, const Screening& run, const TrialCounts& counts,
                             const Trials& trials, std::uint64_t work);

}  // namespace stig::search
