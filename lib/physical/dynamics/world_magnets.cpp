// SPDX-License-Identifier: MIT
// Magnets in a world: placed with their bodies, relaxed or integrated (magnets/magnetism.h), and
// their forces added to bodies that are awake. Sleepers' magnets pull but are not pulled, until the
// pull of something that moves is enough to wake them.
#include <algorithm>
#include <cassert>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

bool moves(const Body& body, const SleepRules& rules) {
  return body.awake &&
         (squared(body.v) > rules.speed * rules.speed || squared(body.w) > rules.spin * rules.spin);
}

// Magnets of one body stand together from `begin` on.
const MagnetDef& def_of(const WorldState& world, std::uint32_t magnet) {
  const std::uint32_t owner = world.magnets[magnet].owner;
  return world.config.bodies[owner].magnets[magnet - world.owners[owner].begin];
}

/// Magnets go with their bodies; those that are fixed in them turn with them.
void place_magnets(WorldState& world) {
  for (const std::uint32_t i : world.awake) {
    const Body& body = world.bodies[i];
    MagnetOwner& owner = world.owners[i];
    owner.centre = body.p;
    for (std::uint32_t k = owner.begin; k < owner.end; ++k) {
      Magnet& magnet = world.magnets[k];
      magnet.p_W = body.p + body.r * world.magnet_places[k];
      if (!magnet.free) magnet.direction = body.r * def_of(world, k).direction;
    }
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    // Fixed bodies keep their place, yet their free magnets turn.
    world.owners[i].awake = world.bodies[i].awake || world.bodies[i].fixed;
  }
}

/// Magnets are solid: where blocks overlap for a moment, theirs do not pull without bound. Only the
/// distance is limited; the direction stays.
void keep_apart(MagnetPair& pair, double least) {
  const double d = length(pair.r);
  if (d < least) pair.r *= least / d;
}

/// A free sphere's own torque never reaches its body: it turns the sphere in its bearing, and the
/// body only by friction there (spin_magnets).
void pull(Body& body, const Magnet& magnet, const Vec3& force, const Vec3& torque) {
  if (!body.awake) return;
  body.force += force;
  body.torque += cross(magnet.p_W - body.p, force);
  if (!magnet.free) body.torque += torque;
}

/// Adds what the magnets do to bodies awake, and fills world.pulls. Where it is not empty,
/// `torques` gets what acts on each magnet.
void apply_pairs(WorldState& world, const std::vector<MagnetPair>& pairs,
                 std::vector<Vec3>& torques) {
  world.pulls.clear();
  for (const MagnetPair& pair : pairs) {
    const Magnet &m0 = world.magnets[pair.i], &m1 = world.magnets[pair.j];
    const DipoleWrench wrench =
        dipole_wrench(m0.direction * m0.moment, m1.direction * m1.moment, pair.r);
    pull(world.bodies[m0.owner], m0, wrench.force, wrench.torque);
    pull(world.bodies[m1.owner], m1, -wrench.force, wrench.torque_on_other);
    if (!torques.empty()) {
      torques[pair.i] += wrench.torque;
      torques[pair.j] += wrench.torque_on_other;
    }
    // Pairs of the same two bodies stand together.
    const BodyPair bodies{m0.owner, m1.owner};
    if (world.pulls.empty() || world.pulls.back().bodies != bodies) {
      world.pulls.push_back({bodies, {}});
    }
    world.pulls.back().force += wrench.force;
  }
}

/// Wakes sleepers that magnets in motion pull at. The sum over all that move counts: four weak
/// magnets may wake together.
void wake_pulled(WorldState& world) {
  const SleepRules& rules = world.config.sleep;
  std::vector<std::pair<std::uint32_t, Vec3>> felt;
  for (const Pull& one : world.pulls) {
    const auto& [a, b] = one.bodies;
    const auto feels = [&](std::uint32_t i, std::uint32_t other) {
      const Body& body = world.bodies[i];
      return !body.awake && !body.fixed && moves(world.bodies[other], rules);
    };
    if (feels(a, b)) felt.emplace_back(a, one.force);
    if (feels(b, a)) felt.emplace_back(b, -one.force);
  }
  const auto by_body = [](const auto& a, const auto& b) { return a.first < b.first; };
  // Stable, so that sums are always added in the same order.
  std::stable_sort(felt.begin(), felt.end(), by_body);
  for (std::size_t k = 0; k < felt.size(); ++k) {
    Vec3 sum = felt[k].second;
    for (; k + 1 < felt.size() && felt[k + 1].first == felt[k].first; ++k) {
      sum += felt[k + 1].second;
    }
    if (squared(sum) > rules.waking_force * rules.waking_force) wake(world, felt[k].first);
  }
}

/// The reference: free spheres that are integrated, see spin_magnet.
void spin_magnets(WorldState& world, const std::vector<Vec3>& torques) {
  for (std::uint32_t k = 0; k < world.magnets.size(); ++k) {
    Magnet& magnet = world.magnets[k];
    if (!magnet.free || !world.owners[magnet.owner].awake) continue;
    Body& body = world.bodies[magnet.owner];
    const Bearing bearing{def_of(world, k).inertia, world.config.bearing_damping};
    // The friction of the bearing acts on the body in this step, by the spin that it had before.
    body.torque += spin_magnet(magnet, torques[k], body.w, bearing, world.config.step);
  }
}

/// All magnets where their bodies are now, and all pairs within the cut-off, whoever is asleep.
/// Copies, since asking must not change the state.
struct StandingMagnets {
  std::vector<Magnet> magnets;
  std::vector<MagnetPair> pairs;
};
StandingMagnets standing_magnets(const WorldState& world) {
  std::vector<MagnetOwner> owners = world.owners;
  for (MagnetOwner& owner : owners) owner.awake = true;
  StandingMagnets out{world.magnets, {}};
  for (std::uint32_t k = 0; k < out.magnets.size(); ++k) {
    Magnet& magnet = out.magnets[k];
    const Body& body = world.bodies[magnet.owner];
    magnet.p_W = body.p + body.r * world.magnet_places[k];
    if (!magnet.free) magnet.direction = body.r * def_of(world, k).direction;
    owners[magnet.owner].centre = body.p;
  }
  out.pairs = magnet_pairs(out.magnets, owners, world.magnet_radius, world.config.magnet_cutoff);
  return out;
}

}  // namespace

void add_magnet_forces(WorldState& world) {
  const WorldConfig& config = world.config;
  place_magnets(world);
  std::vector<MagnetPair> pairs =
      magnet_pairs(world.magnets, world.owners, world.magnet_radius, config.magnet_cutoff);
  for (MagnetPair& pair : pairs) keep_apart(pair, config.magnet_contact);
  const bool relaxed = config.magnets == MagnetModel::quasi_static;
  if (relaxed) {
    relax_magnets(world.magnets, pairs, world.owners, config.step, config.relaxation);
  }
  std::vector<Vec3> torques(relaxed ? 0 : world.magnets.size());
  apply_pairs(world, pairs, torques);
  if (!relaxed) spin_magnets(world, torques);
  wake_pulled(world);
}

// At current places: bodies may have been moved by a hand since the last step.
void wake_magnet_partners(WorldState& world, std::uint32_t body) {
  assert(body < world.owners.size());
  const auto place = [&](std::uint32_t k) {
    const Body& owner = world.bodies[world.magnets[k].owner];
    return owner.p + owner.r * world.magnet_places[k];
  };
  const double cutoff = world.config.magnet_cutoff;
  const MagnetOwner& own = world.owners[body];
  for (std::uint32_t i = 0; i < world.owners.size(); ++i) {
    const MagnetOwner& other = world.owners[i];
    if (i == body || squared(world.bodies[i].p - world.bodies[body].p) >
                         std::pow(cutoff + 2 * world.magnet_radius, 2)) {
      continue;
    }
    bool near = false;
    for (std::uint32_t k = own.begin; k < own.end && !near; ++k) {
      // All pairs of magnets of two bodies that are near: it is rare that a current changes or a
      // body is put elsewhere.
      for (std::uint32_t l = other.begin; l < other.end && !near; ++l) {
        near = squared(place(k) - place(l)) < cutoff * cutoff;
      }
    }
    if (near) wake(world, i);
  }
}

double magnet_energy(const WorldState& world) {
  const StandingMagnets now = standing_magnets(world);
  double energy = 0;
  for (std::uint32_t k = 0; k < now.magnets.size(); ++k) {
    energy += def_of(world, k).inertia * squared(now.magnets[k].spin) / 2;
  }
  for (const MagnetPair& pair : now.pairs) {
    const Magnet &m0 = now.magnets[pair.i], &m1 = now.magnets[pair.j];
    energy += dipole_energy(m0.direction * m0.moment, m1.direction * m1.moment, pair.r);
  }
  return energy;
}

std::vector<Vec3> magnet_forces(const WorldState& world) {
  StandingMagnets now = standing_magnets(world);
  std::vector<Vec3> out(world.bodies.size());
  for (MagnetPair& pair : now.pairs) {
    keep_apart(pair, world.config.magnet_contact);
    const Magnet &m0 = now.magnets[pair.i], &m1 = now.magnets[pair.j];
    const DipoleWrench wrench =
        dipole_wrench(m0.direction * m0.moment, m1.direction * m1.moment, pair.r);
    out[m0.owner] += wrench.force;
    out[m1.owner] -= wrench.force;
  }
  return out;
}

}  // namespace stig::physics
