// SPDX-License-Identifier: MIT
// What stigc synth says of what it found: as a summary, as the reason why there is no rule
// set, or as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "report.h"
#include "synthesis/synthesise.h"
#include "uses.h"
#include "verify/reachability.h"
#include "verify/verify.h"

namespace stig::cli {

/// What came of it, besides the synthesis itself.
struct SynthOutcome {
  std::vector<Cell> scaffold;
  Findings findings;  ///< whether bricks can be walled in
  VerifyResult proof;
  /// That one colour fewer does not do, as far as the checker derives every clause of it.
  std::optional<MinimalityProof> fewest;
  std::vector<std::string> written;
};

Json synth_json(const SynthOptions& options, const Synthesis& result, const SynthOutcome& outcome);

/// Lines about the best solution, which there must be.
std::string synth_summary(const Synthesis& result, const SynthOutcome& outcome);

/// Why there is no rule set, or none was found: of a synthesis with an obstacle.
std::string synth_reason(const Synthesis& result, bool color);

/// That none of the orders tried works.
std::string orders_in_words(std::size_t tried);

}  // namespace stig::cli
