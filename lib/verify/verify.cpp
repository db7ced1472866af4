// SPDX-License-Identifier: MIT
// The verdict on a rule set, stage by stage. A stage is run once; if it ends, its end is
// the candidate X of the proof (stage_proof.h), and if it does not, a repetition in its
// growth is looked for. Stages are proved from one structure each: if a stage ends in
// several, only whole orders through all stages can refute the set, and otherwise it stays
// unknown.
#include "verify/verify.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "certify/check.h"
#include "rules/rule_printer.h"
#include "verify/endless.h"
#include "verify/refutation.h"

namespace stig::verify {
namespace {

constexpr std::uint32_t kFirstRun = 0;  ///< its stream of random numbers
/// Repetitions are sought in a short run, newest site first: that grows a single limb,
/// whose period shows early, where a random order would interleave many.
constexpr std::uint64_t kProbe = 4000;  ///< deposits in search of a repetition
constexpr std::uint64_t kMostDeposits = 20'000'000;
/// Deposits after which growth that is known to be able to go on for ever is not waited
/// for. A set with one endless order may still end in another, which refutes it; that is
/// tried briefly, not waited for.
constexpr std::uint64_t kPatience = 20'000;
constexpr std::uint32_t kTries = 16;  ///< to find an end of such a set

class Verification {
 public:
  Verification(const RuleSet& rules, const VerifyOptions& options)
      : rules_(rules), options_(options), table_(rules), world_(table_, rules.start, options.box) {
    budget_.end = time_after(options.seconds);
    budget_.states = options.states;
    budget_.stop = options.stop;
    budget_.work = options.work;
    budget_.done = &result_.work;
  }

  VerifyResult run() {
    certificate_.rule_set_hash = rule_set_hash(rules_);
    if (options_.box) {
      certificate_.box = BoxSpec{options_.box->size, options_.box->low, options_.box->periodic};
    }
    result_.verdict = ProofVerdict::proved;
    do {
      result_.stage = world_.stage();
      decide_stage();
    } while (result_.verdict == ProofVerdict::proved && world_.next_stage());
    if (result_.verdict == ProofVerdict::proved) verify_certificate();
    if (result_.verdict == ProofVerdict::proved || have_structure_) {
      result_.structure = world_.take_structure();
    }
    result_.interrupted = options_.stop != nullptr && options_.stop->load();
    if (result_.interrupted && result_.verdict == ProofVerdict::unknown) {
      result_.open = "interrupted";
    }
    return std::move(result_);
  }

 private:
  /// Nothing is called proved that the checker does not accept. The last instance is the
  /// checker, which shares no code with the search. A refusal is a fault of the search and
  /// is reported as unknown, with the checker's reason.
  void verify_certificate() {
    say("checking the certificate");
    budget_.spend(world_.structure().size() * kStepsOfLook + result_.local_states * kStepsOfState);
    certificate_.bricks = world_.structure().size();
    const CheckReport report = check_certificate(rules_, certificate_, certificate_.box);
    if (report.accepted) {
      result_.certificate = std::move(certificate_);
      return;
    }
    result_.verdict = ProofVerdict::unknown;
    result_.open = "a proof was found that the checker does not accept: " + report.refusal;
  }

  void say(const std::string& what) const {
    if (options_.progress) options_.progress(world_.stage(), what);
  }

  void decide_stage() {
    // The copy of the world at the stage's beginning is what every later search starts from.
    const LatticeWorld begin = world_;
    StageRun probe;
    std::optional<Repetition> repetition;
    // In a box, or with a number of deposits, every order ends; there is nothing to look
    // for.
    if (!options_.box && table_.stage_limit(world_.stage()) == 0) {
      say("looking for growth that repeats");
      probe = probe_growth(begin, repetition);
    }
    say("building");
    StageRunConfig config;
    config.run = kFirstRun;
    config.most = repetition ? kPatience : kMostDeposits;
    StageRun run = run_stage(world_, config, budget_);
    // One order ends and one grows for ever: these two are the refutation.
    if (!run.ended && repetition && end_some_way(begin, run)) {
      return refute(begin, run, probe.deposits);
    }
    if (!run.ended) return leave_growing(run, probe, repetition);
    if (repetition) return refute(begin, run, probe.deposits);
    say("proving " + counted(run.deposits.size(), "brick"));
    StageProof proof = prove_stage(rules_, table_, begin, run, budget_);
    result_.local_states += proof.local_states;
    if (proof.kind == StageProof::Kind::refuted) return refute(begin, run, proof.other.deposits);
    if (proof.kind == StageProof::Kind::unknown) return leave_open(run.deposits, proof.open);
    // The verdict's method is the least local one that any stage needed.
    result_.method = std::max(result_.method, proof.method);
    certificate_.stages.push_back(std::move(proof.certificate));
    keep(proof.run);
  }

  StageRun probe_growth(const LatticeWorld& begin, std::optional<Repetition>& repetition) {
    LatticeWorld world = begin;
    StageRunConfig config;
    config.schedule = RunOrder::newest;
    config.most = kProbe;
    StageRun run = run_stage(world, config, budget_);
    if (!run.ended) repetition = find_repetition(rules_, begin.structure().bricks(), run.deposits);
    return run;
  }

  /// Does some order end, of a set in which one goes on for ever?
  bool end_some_way(const LatticeWorld& begin, StageRun& run) const {
    for (std::uint32_t i = 1; i <= kTries && !budget_.spent(); ++i) {
      LatticeWorld world = begin;
      StageRunConfig config;
      config.schedule = i == 1 ? RunOrder::oldest : RunOrder::random;
      config.run = i;
      config.most = kProbe;
      run = run_stage(world, config, budget_);
      if (run.ended) return true;
    }
    return false;
  }

  void keep(const std::vector<Deposit>& run) {
    result_.run.insert(result_.run.end(), run.begin(), run.end());
    for (std::size_t i = 0; i < result_.run.size(); ++i) result_.run[i].step = i + 1;
    result_.stage_ends.push_back(result_.run.size());
  }

  void leave_growing(const StageRun& run, const StageRun& probe,
                     const std::optional<Repetition>& repetition) {
    if (!repetition) {
      result_.verdict = ProofVerdict::unknown;
      result_.open = fmt::format(
          "a run placed {} and was not at its end; no repetition was seen in its growth",
          counted(run.deposits.size(), "brick"));
      return;
    }
    result_.verdict = ProofVerdict::endless;
    EndlessGrowth& endless = result_.endless.emplace();
    endless.run = result_.run;
    endless.run.insert(endless.run.end(), probe.deposits.begin(), probe.deposits.end());
    for (std::size_t i = 0; i < endless.run.size(); ++i) endless.run[i].step = i + 1;
    endless.period = repetition->period;
    endless.step = repetition->step;
  }

  void leave_open(const std::vector<Deposit>& run, const std::string& why) {
    result_.verdict = ProofVerdict::unknown;
    result_.open = why;
    keep(run);
    // One run's end is shown, even if others may end elsewhere, but only when it went
    // through all stages.
    have_structure_ = world_.stage() == table_.stage_count();
  }

  void refute(const LatticeWorld& begin, const StageRun& run, const std::vector<Deposit>& other) {
    say("looking for the deposit that makes the difference");
    result_.verdict = ProofVerdict::refuted;
    result_.refutation =
        explain_refutation(rules_, table_, begin, result_.run, run.deposits, other, budget_);
    // Differences after one stage that a later stage levels are no refutation; random whole
    // orders are the last attempt.
    if (!result_.refutation && table_.stage_count() > 1) {
      result_.refutation =
          find_whole_orders(LatticeWorld(table_, rules_.start, options_.box), budget_);
    }
    if (result_.refutation) return;
    result_.verdict = ProofVerdict::unknown;
    result_.open = budget_.spent()
                       ? "the effort or time allowed ended while two orders were compared"
                       : fmt::format(
                             "stage {} ends differently for different orders; what later "
                             "stages make of each of these ends is not explored",
                             begin.stage());
  }

  const RuleSet& rules_;
  const VerifyOptions& options_;
  RuleTable table_;
  LatticeWorld world_;
  Budget budget_;
  Certificate certificate_;
  bool have_structure_ = false;
  VerifyResult result_;
};

}  // namespace

std::string_view to_string(ProofVerdict verdict) {
  switch (verdict) {
    case ProofVerdict::proved:
      return "proved";
    case ProofVerdict::refuted:
      return "refuted";
    case ProofVerdict::endless:
      return "endless";
    case ProofVerdict::unknown:
      break;
  }
  return "unknown";
}

std::string_view to_string(ProofMethod method) {
  switch (method) {
    case ProofMethod::certificate:
      return "certificate";
    case ProofMethod::components:
      return "components";
    case ProofMethod::exhaustive:
      break;
  }
  return "exhaustive";
}

std::optional<Box> file_box(const RuleSet& rules) {
  if (!rules.box) return std::nullopt;
  return lay_box(*rules.box, rules.start, rules.floor);
}

VerifyResult verify(const RuleSet& rules, const VerifyOptions& options) {
  return Verification(rules, options).run();
}

/// Used for trials with changed rule sets. Progress is silenced, and the work goes on the
/// caller's account.
VerifyResult verify_within(const RuleSet& rules, const VerifyOptions& options,
                           const Budget& budget) {
  VerifyOptions again = options;
  again.work = budget.work_left();
  again.seconds = budget.seconds_left();
  again.progress = {};
  VerifyResult result = verify(rules, again);
  budget.spend(result.work);
  return result;
}

}  // namespace stig::verify
