// SPDX-License-Identifier: MIT
#include "search/coordination.h"

#include "verify/verify.h"

namespace stig::search {
namespace {

/// Fillings that the verifier may hold for a candidate: some megabytes.
constexpr std::uint64_t kMostStates = 100'000;

Coordination proved_by(ProofMethod method) {
  switch (method) {
    case ProofMethod::components:
      return Coordination::components;
    case ProofMethod::exhaustive:
      return Coordination::exhaustive;
    case ProofMethod::certificate:
      break;
  }
  return Coordination::certificate;
}

}  // namespace

Coordination coordination_of(const Genome& genome, const Screening& run, const TrialCounts& counts,
                             const Trials& trials, std::uint64_t work) {
  if (work == 0 || !run.saturated) return Coordination::not_asked;
  if (counts.orders > 0 && trials.same_ends < 1) return Coordination::other_ends;
  VerifyOptions options;
  options.work = work;
  options.states = kMostStates;
  const VerifyResult result = verify::verify(rule_set_of(genome), options);
  switch (result.verdict) {
    case ProofVerdict::proved:
      return proved_by(result.method);
    case ProofVerdict::refuted:
      return Coordination::refuted;
    case ProofVerdict::endless:
      return Coordination::endless;
    case ProofVerdict::unknown:
      break;
  }
  return Coordination::undecided;
}

}  // namespace stig::search
