// SPDX-License-Identifier: MIT
// Members are made in the order in which they are declared, and the world before all that looks at
// it.
#include "physical/simulation/run_state.h"

#include "base/hash.h"
#include "physical/dynamics/ticks.h"

namespace stig::physics {

namespace {

constexpr double kLookSeconds = 0.2;

}  // namespace

RunState::RunState(const Scene& its_scene, const PlacedScene& its_placed, bool is_resumable,
                   const ControllerFactory& its_controllers)
    : scene(&its_scene),
      placed(its_placed),
      resumable(is_resumable),
      controllers(its_controllers),
      world(placed.config),
      agents(its_scene, its_placed, is_resumable, its_controllers),
      supply(its_scene),
      odometer(its_scene),
      script(its_scene, its_placed) {}

bool looks_now(const RunState& run) {
  return run.world.tick() % ticks_in(kLookSeconds, run.placed.config.step) == 0;
}

// Programs have states too: two runs that only look alike differ here.
std::uint64_t hash_of(const RunState& run) {
  const Crew* crew = run.agents.crew();
  if (crew == nullptr) return run.world.hash();
  return combine(run.world.hash(), hash_text(crew->state()));
}

}  // namespace stig::physics
