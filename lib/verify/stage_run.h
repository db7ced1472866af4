// SPDX-License-Identifier: MIT
// One order of the events of one stage, recorded.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lattice/swarm.h"
#include "lattice/world.h"
#include "verify/budget.h"

namespace stig {

/// Which of the open sites is next. Different schedules find different ends, and the
/// newest first grows a single limb, whose period is easily seen.
enum class Schedule : std::uint8_t { random, newest, oldest };

struct StageRunConfig {
  Schedule schedule = Schedule::random;
  std::uint32_t run = 0;         ///< a stream of random numbers of its own
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
StageRun run_stage(World& world, const StageRunConfig& config, const Budget& budget);

/// A world with these bricks, at the beginning of a stage.
World world_at_stage(const RuleTable& rules, const std::vector<PlacedBrick>& bricks,
                     const std::optional<Box>& box, int stage);

}  // namespace stig
