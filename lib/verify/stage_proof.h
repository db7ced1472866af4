// SPDX-License-Identifier: MIT
// One stage from one structure: proved, refuted, or neither within the budget.
//
// The first run says what X would be; others that differ refute. Then the strongest
// invariant that orders neighbours is sought (local_proof.h). Where that leaves sites
// open, the bricks around them become groups whose fillings are enumerated (window.h), the
// groups growing until the proof holds, or a real order of events turns up that ends
// otherwise, or the budget is spent. In the end the whole stage is one group, and the
// search is a plain exhaustion of all orders.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/certificate.h"
#include "verify/budget.h"
#include "verify/stage_run.h"
#include "verify/uses.h"

namespace stig::verify {

enum class ProofMethod : std::uint8_t { certificate, components, exhaustive };

struct StageProof {
  enum class Kind : std::uint8_t { proved, refuted, unknown };
  Kind kind = Kind::unknown;

  ProofMethod method = ProofMethod::certificate;
  CertifiedStage certificate;      ///< proved
  std::vector<Deposit> run;        ///< proved: the certificate's witness run
  std::uint64_t local_states = 0;  ///< local states and fillings looked at

  /// refuted: another order of events. It ends without a brick of the first run, or has a
  /// brick that the first run has not.
  StageRun other;

  std::string open;  ///< unknown: what was explored and where it stopped, in words
};

/// `before`: the world at the beginning of its present stage; `run`: a run of that stage
/// from there which ended.
StageProof prove_stage(const RuleSet& rules, const RuleTable& table, const LatticeWorld& before,
                       const StageRun& run, const Budget& budget);

}  // namespace stig::verify
