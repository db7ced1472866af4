// SPDX-License-Identifier: MIT
// Orders of events that a model's run did not foresee: each is tried for real, and the first
// that is at odds with the run refutes the stage.
#pragma once

#include <optional>
#include <vector>

#include "verify/local_proof.h"
#include "verify/uses.h"
#include "verify/window.h"

namespace stig::verify {

class OtherOrders {
 public:
  /// All must outlive it.
  OtherOrders(const LatticeWorld& before, const StageModel& model, const Budget& budget)
      : before_(before), model_(model), budget_(budget) {}

  /// The order that was found to end without a brick of the model's run, or to have a
  /// brick that the run has not.
  std::optional<StageRun>& found() { return found_; }

  /// Runs with several schedules. True: one is at odds. Otherwise `agreed` is weakened to
  /// what holds in all of them.
  bool runs_differ(std::vector<Mask>& agreed);
  /// Deposits these bricks in this order, then one at `site` that the run has not (unless
  /// that is StageModel::kNone), and runs on.
  bool path_differs(const std::vector<std::uint32_t>& path, std::uint32_t site);
  /// Tries to bring failed local states about.
  bool provoked(const Invariant& invariant, const std::vector<LocalFailure>& failures);

 private:
  bool differs(StageRun&& run);
  bool completion_differs(LatticeWorld world, std::vector<Deposit> done, std::uint32_t stream);
  bool deposit(LatticeWorld& world, Cell site, std::uint64_t colours,
               std::vector<Deposit>& done) const;
  bool provokes(const Invariant& invariant, const LocalFailure& failure, std::uint32_t stream);
  bool shown_by(const Window& window, const LocalFailure& failure);

  const LatticeWorld& before_;
  const StageModel& model_;
  const Budget& budget_;
  std::optional<StageRun> found_;
};

}  // namespace stig::verify
