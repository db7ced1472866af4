// SPDX-License-Identifier: MIT
#include "physical/world_state.h"

namespace stig {

namespace {

bool moves(const Body& body, const SleepRules& rules) {
  return body.awake &&
         (squared(body.v) > rules.speed * rules.speed || squared(body.w) > rules.spin * rules.spin);
}

void place_magnets(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    const Body& body = world.bodies[i];
    MagnetOwner& owner = world.owners[i];
    owner.centre = body.p;
    for (std::uint32_t k = owner.begin; k < owner.end; ++k) {
      world.magnets[k].p_W = body.p + body.r * world.magnet_places[k];
    }
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    // Fixed bodies keep their place, yet their free magnets turn.
    world.owners[i].awake = world.bodies[i].awake || world.bodies[i].fixed;
  }
}

/// Magnets that are fixed in a body turn with it.
void turn_fixed_magnets(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    const MagnetOwner& owner = world.owners[i];
    for (std::uint32_t k = owner.begin; k < owner.end; ++k) {
      Magnet& magnet = world.magnets[k];
      if (magnet.free) continue;
      const std::size_t number = k - owner.begin;
      magnet.direction = world.bodies[i].r * world.config.bodies[i].magnets[number].direction;
    }
  }
}

/// Magnets are solid: where blocks overlap for a moment, theirs do not pull without bound.
void keep_apart(MagnetPair& pair, double least) {
  const double d = length(pair.r);
  if (d < least) pair.r *= least / d;
}

void pull(Body& body, const Magnet& magnet, const Vec3& force, const Vec3& torque) {
  body.force += force;
  body.torque += cross(magnet.p_W - body.p, force);
  // A free sphere's own torque is lost in its bearing.
  if (!magnet.free) body.torque += torque;
}

void apply_magnets(WorldState& world, const std::vector<MagnetPair>& pairs) {
  const SleepRules& rules = world.config.sleep;
  std::vector<Vec3> felt(world.bodies.size());
  for (const MagnetPair& pair : pairs) {
    const Magnet &m0 = world.magnets[pair.i], &m1 = world.magnets[pair.j];
    Body &a = world.bodies[m0.owner], &b = world.bodies[m1.owner];
    const DipoleWrench wrench =
        dipole_wrench(m0.direction * m0.moment, m1.direction * m1.moment, pair.r);
    pull(a, m0, wrench.force, wrench.torque);
    pull(b, m1, -wrench.force, wrench.torque_on_other);
    if (!a.awake && !a.fixed && moves(b, rules)) felt[m0.owner] += wrench.force;
    if (!b.awake && !b.fixed && moves(a, rules)) felt[m1.owner] -= wrench.force;
  }
  for (std::uint32_t i = 0; i < felt.size(); ++i) {
    if (squared(felt[i]) > rules.waking_force * rules.waking_force) wake(world, i);
  }
}

}  // namespace

void gather_forces(WorldState& world) {
  for (Body& body : world.bodies) {
    body.force = body.user_force + Vec3{0, 0, -world.config.gravity * body.mass};
    body.torque = body.user_torque;
  }
  if (world.magnets.empty()) return;
  place_magnets(world);
  turn_fixed_magnets(world);
  std::vector<MagnetPair> pairs =
      magnet_pairs(world.magnets, world.owners, world.magnet_radius, world.config.magnet_cutoff);
  for (MagnetPair& pair : pairs) keep_apart(pair, world.config.magnet_contact);
  relax_magnets(world.magnets, pairs, world.owners, world.config.step, world.config.relaxation);
  apply_magnets(world, pairs);
}

void integrate_velocity(WorldState& world, std::uint32_t number) {
  Body& body = world.bodies[number];
  if (body.fixed) return;
  if (Articulation* articulation = articulation_of(world, number)) {
    if (articulation->links[0].body != number) return;
    kick(*articulation, world.bodies, world.config.step);
    set_body_velocities(*articulation, world.bodies);
    return;
  }
  body.kick_v = body.force * (world.config.step / body.mass);
  body.kick_w = body.inverse_inertia() * body.torque * world.config.step;
  body.v += body.kick_v;
  body.w += body.kick_w;
}

double magnet_energy(const WorldState& world) {
  std::vector<MagnetOwner> owners = world.owners;
  for (MagnetOwner& owner : owners) owner.awake = true;
  std::vector<Magnet> magnets = world.magnets;
  for (std::size_t i = 0; i < magnets.size(); ++i) {
    const Body& body = world.bodies[magnets[i].owner];
    magnets[i].p_W = body.p + body.r * world.magnet_places[i];
    owners[magnets[i].owner].centre = body.p;
  }
  double energy = 0;
  for (const MagnetPair& pair :
       magnet_pairs(magnets, owners, world.magnet_radius, world.config.magnet_cutoff)) {
    const Magnet &m0 = magnets[pair.i], &m1 = magnets[pair.j];
    energy += dipole_energy(m0.direction * m0.moment, m1.direction * m1.moment, pair.r);
  }
  return energy;
}

}  // namespace stig
