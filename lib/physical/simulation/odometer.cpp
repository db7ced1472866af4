// SPDX-License-Identifier: MIT
// Straight lines between looks five times a second: way on the floor, without the jitter of single
// steps, of which a robot at rest would make metres in an hour.
#include "physical/simulation/odometer.h"

#include "physical/simulation/run_state.h"

namespace stig::physics {

Odometer::Odometer(const Scene& scene) {
  for (const RobotSpawn& robot : scene.robots) robots_.push_back({0, robot.X_WR.p});
}

void Odometer::before_step(RunState& run, const RunHooks& /*hooks*/) {
  if (!looks_now(run)) return;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Vec3 at = run.agents.crew()->robot_pose(run.world, i).p;
    at.z = 0;
    robots_[i].driven += length(at - robots_[i].last);
    robots_[i].last = at;
  }
}

}  // namespace stig::physics
