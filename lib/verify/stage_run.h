// SPDX-License-Identifier: MIT
// One order of the events of one stage, recorded.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lattice/cell_map.h"
#include "lattice/swarm.h"
#include "lattice/world.h"
#include "verify/budget.h"
#include "verify/uses.h"

namespace stig::verify {

/// Which of the open sites is next. Different schedules find different ends, and the
/// newest first grows a single limb, whose period is easily seen.
/// planned: what comes first in a plan; then the rest.
enum class RunOrder : std::uint8_t { random, newest, oldest, planned };

/// An order to keep to as far as the rules allow it: each site's place in it and what it
/// takes there.
class Plan {
 public:
  explicit Plan(const std::vector<Deposit>& order);
  /// Sites that are not in the plan come last.
  std::uint32_t rank(Cell site) const { return steps_.at(site).rank; }
  Colour colour(Cell site) const { return steps_.at(site).colour; }

 private:
  struct Step {
    std::uint32_t rank = ~std::uint32_t{0};
    Colour colour = 0;
  };
  CellMap<Step> steps_;
};

struct StageRunConfig {
  RunOrder schedule = RunOrder::random;
  const Plan* plan = nullptr;      ///< of RunOrder::planned
  std::uint32_t run = 0;           ///< a stream of random numbers of its own
  std::uint64_t most = 1'000'000;  ///< deposits
  /// Sites for which it says no are left open. Empty: all may be filled.
  std::function<bool(Cell)> may_fill;
};

struct StageRun {
  std::vector<Deposit> deposits;
  bool ended = false;  ///< no site is open, or the stage has had its deposits
};

/// Runs the world's present stage on from where it is. Probabilities count as 1: what may
/// fire does.
StageRun run_stage(LatticeWorld& world, const StageRunConfig& config, const Budget& budget);

/// A world with these bricks, at the beginning of a stage.
LatticeWorld world_at_stage(const RuleTable& rules, const std::vector<PlacedBrick>& bricks,
                            const std::optional<Box>& box, int stage);

}  // namespace stig::verify
