// SPDX-License-Identifier: MIT
// Forces of a step are gathered in fixed order: pushes and weight, damping, magnets, then what
// functions of the user add. Velocities take them up before contacts are solved.
#include <cassert>
#include <cmath>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

// For questions about motion that weight must not answer (see steady in world_contacts.cpp).
void remember(Body& body) {
  body.last_v = body.v;
  body.last_w = body.w;
}

/// The force whose impulse over a step is what the decay takes, for any rate. expm1 keeps the
/// digits of a small product.
void add_damping(WorldState& world) {
  const double dt = world.config.step;
  const double linear = -std::expm1(-world.config.damping * dt) / dt;
  const double angular = -std::expm1(-world.config.angular_damping * dt) / dt;
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    body.force -= body.v * (linear * body.mass);
    body.torque -= body.r * scaled(body.inertia, body.r.transposed(body.w)) * angular;
  }
}

}  // namespace

void gather_forces(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    body.force = body.user_force + Vec3{0, 0, -world.config.gravity * body.mass};
    body.torque = body.user_torque;
  }
  if (world.config.damping > 0 || world.config.angular_damping > 0) add_damping(world);
  if (!world.magnets.empty()) add_magnet_forces(world);
}

void integrate_velocity(WorldState& world, std::uint32_t number) {
  assert(number < world.bodies.size());
  Body& body = world.bodies[number];
  if (body.fixed) return;
  if (Articulation* articulation = articulation_of(world, number)) {
    // A mechanism goes with its first link, once.
    if (articulation->links[0].body != number) return;
    for (const LinkBody& link : articulation->links) remember(world.bodies[link.body]);
    kick(*articulation, world.bodies, world.config.step);
    set_body_velocities(*articulation, world.bodies);
    return;
  }
  remember(body);
  // Kept beside v as well: the solver takes them out again and gives them in small steps.
  body.kick_v = body.force * (world.config.step / body.mass);
  body.kick_w = body.inverse_inertia() * body.torque * world.config.step;
  body.v += body.kick_v;
  body.w += body.kick_w;
}

}  // namespace stig::physics
