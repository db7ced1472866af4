// SPDX-License-Identifier: MIT
// Finds the strongest `before` that holds in every reachable structure, and whether it
// proves the stage (conditions 2 and 3 of certify/check.h).
//
// Houdini's scheme (Flanagan & Leino 2001, "Houdini, an annotation assistant for
// ESC/Java"): start from every "p before q" that the runs made so far agree with, drop
// those that some event could break, and repeat where that makes more local states
// possible, until nothing changes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "verify/budget.h"
#include "verify/invariant.h"
#include "verify/uses.h"

namespace stig::verify {

/// Why a site keeps the stage from being proved.
struct LocalFailure {
  enum class Kind : std::uint8_t {
    wrong,     ///< a rule could place a brick that the run did not
    stuck,     ///< it could stay empty where the run found it open
    too_many,  ///< more local states than are looked at
  };
  Kind kind = Kind::wrong;
  std::uint32_t site = 0;
  Mask state = 0;  ///< an example, not known to occur; of neighbours that matter
  Mask seen = 0;   ///< neighbours that matter
};

struct LocalProof {
  bool finished = false;  ///< false: the budget was spent
  std::vector<LocalFailure> failures;
  std::uint64_t local_states = 0;  ///< that the invariant leaves possible, over all sites
};

/// For each brick the neighbours that a run placed before it.
std::vector<Mask> placed_before(const StageModel& model, const std::vector<Deposit>& run);

/// Weakens invariant.before until it holds. `first` is placed_before of the model's run.
LocalProof prove_locally(const StageModel& model, const std::vector<Mask>& first,
                         Invariant& invariant, const Budget& budget);

}  // namespace stig::verify
