// SPDX-License-Identifier: MIT
// Does every order of events end in the same structure?
//
//   proved    yes: the certificate says why, and certify/check.h re-checks it
//   refuted   no: two orders of events that end differently
//   endless   no: an order of events that goes on for ever, with the step by which its
//             growth repeats
//   unknown   neither was shown within the budget
//
// Every verdict but the last is a theorem about the rule set, its start and the box; a
// probability only means that a rule may fire. docs/proofs.md has the argument.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certify/certificate.h"
#include "lattice/structure.h"
#include "lattice/swarm.h"
#include "verify/budget.h"
#include "verify/stage_proof.h"
#include "verify/uses.h"

namespace stig::verify {

enum class ProofVerdict : std::uint8_t { proved, refuted, endless, unknown };
std::string_view to_string(ProofVerdict verdict);  ///< "proved"
std::string_view to_string(ProofMethod method);    ///< "components"

inline constexpr std::uint64_t kVerifyWork = 60'000'000'000;

struct VerifyOptions {
  std::optional<Box> box;            ///< none: unbounded space. The file's own box: file_box()
  std::uint64_t work = kVerifyWork;  ///< steps (budget.h)
  double seconds = kNoTimeLimit;
  std::uint64_t states = 2'000'000;  ///< fillings held of one group of bricks
  const std::atomic<bool>* stop = nullptr;
  /// Now and then: the stage and what is being done, in words.
  std::function<void(int stage, const std::string& what)> progress;
};

/// The box that the file names, laid around its start.
std::optional<Box> file_box(const RuleSet& rules);

/// Two orders of events that end differently. They are the same at first, and part in the
/// structure that those deposits give.
struct DivergingOrders {
  std::vector<Deposit> first, second;  ///< from the start
  std::size_t common = 0;              ///< deposits that they share
  /// Deposits of each order up to the end of the stage in which they part.
  std::size_t first_stage_end = 0, second_stage_end = 0;
  bool second_ended = false;  ///< false: it has a brick that the first never gets
  Structure first_end, second_end;
  /// Where they part: the second order does `second[common]` at once. In the first, this
  /// deposit is what that one rules out, or what rules that one out.
  Deposit rival;
  /// What the two sites show when both deposits are still possible.
  View view, rival_view;
};

/// An order of events that never ends: the last `period` deposits of `run` happen again,
/// `step` further on, and again, for ever.
struct EndlessGrowth {
  std::vector<Deposit> run;  ///< from the start
  std::uint64_t period = 0;
  Offset step;
};

struct VerifyResult {
  ProofVerdict verdict = ProofVerdict::unknown;
  /// The structure in which every order ends (proved), or in which one run ended.
  std::optional<Structure> structure;
  std::vector<Deposit> run;                       ///< from the start to that structure
  std::vector<std::size_t> stage_ends;            ///< number of deposits in `run` after each stage
  ProofMethod method = ProofMethod::certificate;  ///< proved: the least local of all stages'
  std::uint64_t local_states = 0;
  std::uint64_t work = 0;                  ///< steps that it took
  std::optional<Certificate> certificate;  ///< proved
  std::optional<DivergingOrders> refutation;
  std::optional<EndlessGrowth> endless;
  int stage = 1;             ///< where it was decided, or where the proof stopped
  bool interrupted = false;  ///< by options.stop
  std::string open;          ///< unknown: what was explored, where it stopped, what would help
};

/// The rule set must fit its box (see config_problem in swarm.h).
VerifyResult verify(const RuleSet& rules, const VerifyOptions& options);
/// The same with what is left of a budget, which pays for it.
VerifyResult verify_within(const RuleSet& rules, const VerifyOptions& options,
                           const Budget& budget);

}  // namespace stig::verify
