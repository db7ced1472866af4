// SPDX-License-Identifier: MIT
#include "physical/world_state.h"

namespace stig {

void gather_forces(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    body.force = body.user_force + Vec3{0, 0, -world.config.gravity * body.mass};
    body.torque = body.user_torque;
  }
  if (!world.magnets.empty()) add_magnet_forces(world);
}

void integrate_velocity(const WorldState& world, Body& body) {
  if (body.fixed) return;
  body.v += body.force * (world.config.step / body.mass);
  body.w += body.inverse_inertia() * body.torque * world.config.step;
}

}  // namespace stig
