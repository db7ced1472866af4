// SPDX-License-Identifier: MIT
#include "physical/world_state.h"

namespace stig {

namespace {

void remember(Body& body) {
  body.last_v = body.v;
  body.last_w = body.w;
}

}  // namespace

void gather_forces(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    body.force = body.user_force + Vec3{0, 0, -world.config.gravity * body.mass};
    body.torque = body.user_torque;
  }
  if (!world.magnets.empty()) add_magnet_forces(world);
}

void integrate_velocity(WorldState& world, std::uint32_t number) {
  Body& body = world.bodies[number];
  if (body.fixed) return;
  if (Articulation* articulation = articulation_of(world, number)) {
    if (articulation->links[0].body != number) return;
    for (const LinkBody& link : articulation->links) remember(world.bodies[link.body]);
    kick(*articulation, world.bodies, world.config.step);
    set_body_velocities(*articulation, world.bodies);
    return;
  }
  remember(body);
  body.kick_v = body.force * (world.config.step / body.mass);
  body.kick_w = body.inverse_inertia() * body.torque * world.config.step;
  body.v += body.kick_v;
  body.w += body.kick_w;
}

}  // namespace stig
