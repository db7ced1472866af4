// SPDX-License-Identifier: MIT
// From two runs that differ to the one deposit that makes the difference.
#pragma once

#include <optional>
#include <vector>

#include "verify/verify.h"

namespace stig {

/// Runs a world on through all of its stages; `stream` numbers the random order taken.
StageRun run_to_the_end(World& world, std::uint32_t stream, std::uint64_t most,
                        const Budget& budget);

/// `earlier`: deposits of the stages before, on which all orders agree; `other`: deposits of
/// the present stage after which the first order's end is out of reach. `first_end`: that
/// end, of a run with `stream` from the beginning of the stage on. None when both runs end
/// in the same structure after all, in a later stage.
std::optional<Refutation> explain_refutation(const RuleSet& rules, const RuleTable& table,
                                             const World& stage_begin,
                                             const std::vector<Deposit>& earlier,
                                             const std::vector<Deposit>& other,
                                             std::uint32_t stream, const Budget& budget);

}  // namespace stig
