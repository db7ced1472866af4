// SPDX-License-Identifier: MIT
// All that a run consists of: its scene, its world, and the parts that are at work in it.
#pragma once

#include <string>

#include "physical/dynamics/world.h"
#include "physical/scene/controller_factory.h"
#include "physical/simulation/block_supply.h"
#include "physical/simulation/event_tally.h"
#include "physical/simulation/force_pushes.h"
#include "physical/simulation/odometer.h"
#include "physical/simulation/run_agents.h"
#include "physical/simulation/run_script.h"
#include "physical/simulation/trace_recorder.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

struct RunState {
  /// The scene must outlive it.
  RunState(const Scene& scene, const PlacedScene& placed, bool resumable,
           const ControllerFactory& controllers);

  const Scene* scene;
  PlacedScene placed;
  bool resumable;
  ControllerFactory controllers;
  World world;
  RunAgents agents;
  BlockSupply supply;
  Odometer odometer;
  ForcePushes pushes;
  RunScript script;
  EventTally tally;
  TraceRecorder recorder;
  bool stop = false;    ///< the script wants the run to end
  std::string message;  ///< why it ended
};

/// Whether caches, ways and the script are looked after before the step to come: every 0.2 s.
bool looks_now(const RunState& run);

/// A hash of the world's state, and of robots and blocks with programs.
std::uint64_t hash_of(const RunState& run);

}  // namespace stig::physics
