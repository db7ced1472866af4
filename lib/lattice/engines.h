// SPDX-License-Identifier: MIT
// The engines behind run_swarm, one a kind of motion, and what they share.
#pragma once

#include "lattice/swarm.h"
#include "lattice/uses.h"
#include "lattice/world.h"

namespace stig::lattice {

/// Book-keeping of a run: counts, limits, hooks. A step begins with begin_step();
/// before that the engine asks whether a limit was reached.
class RunLog {
 public:
  RunLog(const SwarmConfig& config, const SwarmHooks& hooks, std::size_t rules);

  /// The number of the step that begins, 1-based.
  std::uint64_t begin_step() { return ++result_.steps; }
  /// The same for an engine that passes over steps in which nothing happens: begins that step,
  /// later than the last, unless a limit is reached before it.
  bool go_to_step(std::uint64_t step);
  void record(const Deposit& deposit);

  bool deposits_spent() const { return config_->max_deposits == result_.deposits; }
  /// Step limit or stop; also calls the progress hook now and then. `work` is the
  /// number of agent-steps (or events) in a step, to pace the hooks.
  bool limit_reached(std::uint64_t work = 1);
  Terminated why() const { return why_; }

  SwarmResult finish(LatticeWorld& world, Terminated terminated, std::uint64_t enabled_left,
                     std::uint64_t out_of_reach);

 private:
  const SwarmConfig* config_;
  const SwarmHooks* hooks_;
  SwarmResult result_;
  Terminated why_ = Terminated::saturated;
  std::uint64_t work_since_hooks_ = 0;
};

SwarmResult run_event(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks);
/// The same run by the engine for all worlds, also where run_event has a faster one.
SwarmResult run_event_anywhere(LatticeWorld world, const SwarmConfig& config,
                               const SwarmHooks& hooks);
/// The config has a box, here and in run_teleport.
SwarmResult run_walk(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks);
SwarmResult run_teleport(LatticeWorld world, const SwarmConfig& config, const SwarmHooks& hooks);

}  // namespace stig::lattice
