// SPDX-License-Identifier: MIT
// Puts the parts of a stage's proof together (docs/proofs.md, "How certificates are
// found"): runs that might differ, Houdini on the order of neighbours, far chains, groups
// that grow. Every failure is first tried as a refutation, as one real order of events is
// worth more than any strengthening of the proof. The result is a certificate that the
// independent checker sees next, so faults here cost proofs and not soundness.
#include "verify/stage_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "base/text.h"
#include "rules/cell_text.h"
#include "verify/far_order.h"
#include "verify/groups.h"
#include "verify/other_orders.h"

namespace stig::verify {
namespace {

/// Each witness delays more bricks than the one before; the bound keeps sets that it does
/// not help from paying for many.
constexpr int kMostWitnesses = 6;
constexpr int kMostFarRounds = 3;  ///< of looking for far chains

class StageProver {
 public:
  StageProver(const RuleSet& rules, const RuleTable& table, const LatticeWorld& before,
              std::vector<Deposit> run, const Budget& budget)
      : before_(before),
        budget_(budget),
        run_(std::move(run)),
        model_(rules, table, before, run_),
        others_(before, model_, budget) {
    budget.spend(model_.sites() * kStepsOfLook);
  }

  /// The bricks that the run finds open and other orders may find closed.
  const std::set<Cell>& stuck() const { return stuck_; }

  /// `hasty`: give up as soon as the order of neighbours alone does not settle the stage. A
  /// hasty attempt tests a witness run: if bricks get stuck under it, another witness is
  /// tried before groups are.
  StageProof prove(bool hasty) {
    first_ = placed_before(model_, run_);
    agreed_ = first_;
    if (others_.runs_differ(agreed_)) return refuted();
    Groups groups;
    if (attempt(groups)) return std::move(proof_);
    for (const LocalFailure& failure : failures_) {
      if (failure.kind == LocalFailure::Kind::stuck) stuck_.insert(model_.at(failure.site));
    }
    if (others_.found()) return refuted();
    // The bricks that got stuck are handed to the next witness, in which they wait.
    if (hasty && !stuck_.empty()) return std::move(proof_);
    for (int round = 0; !gave_up_ && !budget_.spent(); ++round) {
      grow(groups, round);
      if (gave_up_ || attempt(groups)) return std::move(proof_);
      if (others_.found()) return refuted();
      if (groups.size() == 1 && groups.front().size() == model_.bricks()) break;
    }
    if (proof_.open.empty()) {
      proof_.open =
          fmt::format("the effort or time allowed ended with {} of {} bricks looked at one by one",
                      group_bricks(groups), model_.bricks());
    }
    return std::move(proof_);
  }

 private:
  StageProof refuted() {
    proof_.kind = StageProof::Kind::refuted;
    proof_.other = std::move(*others_.found());
    return std::move(proof_);
  }

  static std::size_t group_bricks(const Groups& groups) {
    std::size_t number = 0;
    for (const auto& group : groups) number += group.size();
    return number;
  }

  /// One round: true when the stage is proved. Otherwise another order may have been found.
  /// The fixed point over three kinds of knowledge that depend on each other: the windows'
  /// fillings depend on `before` of their contexts, `before` on the fillings, and far
  /// chains on `before`. Each pass begins with what has changed; all of them only weaken,
  /// so it ends.
  bool attempt(Groups& groups) {
    invariant_ = {};
    invariant_.before = agreed_;
    invariant_.group_of.assign(model_.bricks(), Invariant::kNoWindow);
    const std::int64_t limit = model_.table().stage_limit(before_.stage());
    // If the stage ends by its number of deposits and the group is everything, full
    // fillings are final (condition 5).
    if (groups.size() == 1 && groups.front().size() == model_.bricks() && limit > 0 &&
        static_cast<std::size_t>(limit) == model_.bricks()) {
      invariant_.over_at = static_cast<std::uint64_t>(limit);
    }
    for (const auto& group : groups) {
      // Group bricks give up their `before`, as condition 4 asks.
      for (const std::uint32_t brick : group) {
        invariant_.before[brick] = 0;
        invariant_.group_of[brick] = static_cast<std::uint32_t>(invariant_.windows.size());
      }
      invariant_.windows.push_back({});
      invariant_.windows.back().group = group;
    }
    failures_.clear();
    int far_rounds = groups.empty() ? kMostFarRounds : 0;
    while (true) {
      // Far chains can restore claims that Houdini dropped for want of them, so it starts
      // again from what held before.
      const std::vector<Mask> held = invariant_.before;
      for (std::uint32_t w = 0; w < groups.size(); ++w) {
        if (!fill(groups, w)) return false;
      }
      LocalProof local = prove_locally(model_, first_, invariant_, budget_);
      if (!local.finished) return false;
      if (drop_broken_chains(model_, invariant_)) continue;
      if (far_rounds > 0 && add_far_chains(model_, local.failures, invariant_)) {
        --far_rounds;
        invariant_.before = held;
        continue;
      }
      proof_.local_states = local.local_states;
      if (!local.failures.empty()) {
        failures_ = std::move(local.failures);
        others_.provoked(invariant_, failures_);
        return false;
      }
      if (!context_changed(held)) break;
    }
    write_proof(groups);
    return true;
  }

  /// Weaker claims about a context brick let it come earlier, so windows with it in their
  /// context have to be explored again.
  bool context_changed(const std::vector<Mask>& held) const {
    for (const Window& window : invariant_.windows) {
      for (const std::uint32_t brick : window.context) {
        if (held[brick] != invariant_.before[brick]) return true;
      }
    }
    return false;
  }

  /// Searches a window, its group growing where the context is at fault. False when that
  /// does not help, or the stage is refuted on the way.
  bool fill(Groups& groups, std::uint32_t number) {
    Window& window = invariant_.windows[number];
    while (true) {
      const auto failure = explore_window(model_, invariant_, budget_, window);
      if (!failure) return true;
      if (failure->kind == WindowFailure::Kind::too_many) {
        gave_up_ = true;
        proof_.open =
            fmt::format("{} of {} explored, and there are more", counted(window.count(), "filling"),
                        counted(window.group.size(), "brick"));
        return false;
      }
      const bool wrong = failure->kind == WindowFailure::Kind::wrong;
      const std::uint32_t site = wrong ? failure->site : StageModel::kNone;
      // A failed filling has a path to it. If the window is exact this is a real order;
      // else it is worth one try.
      if (others_.path_differs(path_to(window, failure->filling), site)) return false;
      const std::uint32_t brick = most_helpful(model_, invariant_, number, budget_);
      if (brick == StageModel::kNone) {
        // With no brick left to take in, all the context is marked as unsettled, which
        // makes `grow` take it in.
        for (const std::uint32_t c : window.context) {
          failures_.push_back({LocalFailure::Kind::too_many, c, 0, 0});
        }
        return false;
      }
      take_into_group(invariant_, brick, number);
      groups[number] = window.group;
    }
  }

  void grow(Groups& groups, int round) {
    if (auto more = grown(model_, groups, failures_, round)) {
      groups = std::move(*more);
      return;
    }
    gave_up_ = true;
    proof_.open = fmt::format(
        "{} sites are not settled by the order of their neighbours{}", failures_.size(),
        failures_.empty() ? "" : ", the first at " + cell_text(model_.at(failures_[0].site)));
  }

  void write_proof(const Groups& groups) {
    proof_.kind = StageProof::Kind::proved;
    // The method names the least local argument that was needed.
    proof_.method = groups.empty() ? ProofMethod::certificate : ProofMethod::components;
    if (groups.size() == 1 && groups.front().size() == model_.bricks()) {
      proof_.method = ProofMethod::exhaustive;
    }
    CertifiedStage& stage = proof_.certificate;
    proof_.run = run_;
    stage.order.reserve(model_.bricks());
    for (std::uint32_t b = 0; b < model_.bricks(); ++b) {
      stage.order.push_back({model_.at(b), model_.run()[b].colour, invariant_.before[b]});
    }
    for (const auto& [brick, chains] : invariant_.far) {
      stage.far.insert(stage.far.end(), chains.begin(), chains.end());
    }
    for (const Window& window : invariant_.windows) {
      proof_.local_states += window.count();
      CertifiedWindow out;
      out.group = window.group;
      out.context = window.context;
      for (std::size_t f = 0; f < window.count(); ++f) {
        const auto first = window.fillings.begin() + static_cast<std::ptrdiff_t>(f * window.words);
        out.fillings.emplace_back(first, first + static_cast<std::ptrdiff_t>(window.words));
      }
      // The search has fillings in the order of discovery; the certificate wants them
      // rising (docs/proofs.md, "The certificate's form").
      std::sort(out.fillings.begin(), out.fillings.end(), [](const Filling& a, const Filling& b) {
        return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
      });
      stage.windows.push_back(std::move(out));
    }
  }

  const LatticeWorld& before_;
  const Budget& budget_;
  std::vector<Deposit> run_;
  StageModel model_;
  OtherOrders others_;
  std::set<Cell> stuck_;
  std::vector<Mask> first_;   ///< placed_before of the model's run
  std::vector<Mask> agreed_;  ///< of all runs
  Invariant invariant_;
  std::vector<LocalFailure> failures_;
  bool gave_up_ = false;
  StageProof proof_;
};

/// Another run, in which some bricks wait until nothing else can be done. The plan is a
/// preference: bricks that wait are placed when nothing else can be, so the run stays a
/// real order of events. An empty result means that it did not end.
std::vector<Deposit> run_with_delays(const LatticeWorld& before, const std::vector<Deposit>& run,
                                     const std::set<Cell>& late, const Budget& budget) {
  std::vector<Deposit> wish;
  for (const bool now : {false, true}) {
    for (const Deposit& deposit : run) {
      if (late.contains(deposit.site) == now) wish.push_back(deposit);
    }
  }
  const Plan plan(wish);
  StageRunConfig config;
  config.schedule = RunOrder::planned;
  config.plan = &plan;
  config.most = run.size() + 1000;
  LatticeWorld world = before;
  StageRun result = run_stage(world, config, budget);
  return result.ended ? std::move(result.deposits) : std::vector<Deposit>{};
}

}  // namespace

StageProof prove_stage(const RuleSet& rules, const RuleTable& table, const LatticeWorld& before,
                       const StageRun& run, const Budget& budget) {
  assert(run.ended);
  // A witness in which bricks come as late as they can leaves less to be shown of them.
  std::set<Cell> late;
  std::vector<Deposit> witness = run.deposits;
  for (int i = 0; i < kMostWitnesses; ++i) {
    StageProver prover(rules, table, before, witness, budget);
    StageProof proof = prover.prove(true);
    if (proof.kind != StageProof::Kind::unknown || prover.stuck().empty()) return proof;
    const std::size_t had = late.size();
    late.insert(prover.stuck().begin(), prover.stuck().end());
    if (late.size() == had) break;
    std::vector<Deposit> next = run_with_delays(before, witness, late, budget);
    // Runs of different length mean different ends, which the attempts to refute have
    // looked at.
    if (next.size() != run.deposits.size()) break;
    witness = std::move(next);
  }
  // The original run again, now with groups: it is the witness that any later message
  // speaks of.
  return StageProver(rules, table, before, run.deposits, budget).prove(false);
}

}  // namespace stig::verify
