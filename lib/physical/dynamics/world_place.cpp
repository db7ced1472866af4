// SPDX-License-Identifier: MIT
// Bodies that a hand puts elsewhere while the world runs.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

// Somewhat farther than contacts are seen (kMargin in world_contacts.cpp).
constexpr double kNear = 1e-3;  ///< m: sleepers nearer than this wake

Placed placed(const Body& body) { return {body.shape, body.p, body.r}; }

/// The body, or all of its mechanism; rising.
std::vector<std::uint32_t> moved_with(WorldState& world, std::uint32_t body) {
  // A mechanism goes in one piece, so its joints stay as they are.
  std::vector<std::uint32_t> out;
  if (const Articulation* it = articulation_of(world, body)) {
    for (const LinkBody& link : it->links) out.push_back(link.body);
    std::sort(out.begin(), out.end());
  } else {
    out.push_back(body);
  }
  return out;
}

/// Why the bodies cannot stand where `shift` takes them; empty: they can.
std::string problem_there(const WorldState& world, const std::vector<std::uint32_t>& bodies,
                          const Pose& shift, PlaceResult& out) {
  for (const std::uint32_t i : bodies) {
    const Body& body = world.bodies[i];
    const Pose X_WB = shift * Pose{body.p, body.q};
    if (!is_finite(X_WB.p) || !inside_arena(X_WB.p, world.config.arena)) {
      return "it would be outside of the arena";
    }
    // What is fixed may stand in the floor, as foundations do.
    if (world.config.floor && !body.fixed && spawns_in_floor(body.shape, X_WB)) {
      return "it would be in the floor";
    }
    for (std::uint32_t k = 0; k < world.bodies.size(); ++k) {
      const Body& other = world.bodies[k];
      if (other.left || (other.fixed && body.fixed)) continue;
      if (std::binary_search(bodies.begin(), bodies.end(), k)) continue;
      if (!spawns_overlap(body.shape, X_WB, other.shape, {other.p, other.q})) continue;
      out.overlaps = true;
      out.body = BodyId{i};
      out.other = BodyId{k};
      return fmt::format("body {} would overlap body {}", i, k);
    }
  }
  return {};
}

/// Wakes all that touches one of the bodies, or whose magnets one of them pulls at. Contacts are
/// those of the last step; where the bodies have none yet, nearness tells. Called before and after
/// a move: neighbours that are left behind lose a support, new ones gain a weight.
void wake_around(WorldState& world, const std::vector<std::uint32_t>& bodies) {
  const auto moved = [&bodies](std::uint32_t i) {
    return std::binary_search(bodies.begin(), bodies.end(), i);
  };
  for (const Contact& contact : world.contacts) {
    if (contact.b == kFloorBody || moved(contact.a) == moved(contact.b)) continue;
    wake(world, moved(contact.a) ? contact.b : contact.a);
  }
  for (const std::uint32_t i : bodies) {
    const Body& body = world.bodies[i];
    for (std::uint32_t k = 0; k < world.bodies.size(); ++k) {
      const Body& other = world.bodies[k];
      const double reach = body.shape.radius() + other.shape.radius() + kNear;
      if (other.awake || other.left || moved(k)) continue;
      if (squared(other.p - body.p) > reach * reach) continue;
      if (touch(placed(body), placed(other), kNear).count > 0) wake(world, k);
    }
    wake_magnet_partners(world, i);
  }
}

/// Free magnets turn with their body and stand still in it.
void carry_magnets(WorldState& world, std::uint32_t number, const Mat3& turn) {
  const Body& body = world.bodies[number];
  MagnetOwner& owner = world.owners[number];
  owner.centre = body.p;
  for (std::uint32_t k = owner.begin; k < owner.end; ++k) {
    Magnet& magnet = world.magnets[k];
    magnet.p_W = body.p + body.r * world.magnet_places[k];
    magnet.direction = normalised(turn * magnet.direction);
    magnet.spin = {};
  }
}

void set_down(WorldState& world, std::uint32_t number, const Pose& X_WB) {
  Body& body = world.bodies[number];
  body.p = X_WB.p;
  body.q = normalised(X_WB.q);
  body.r = matrix(body.q);
  // Whatever it had of motion stays behind.
  body.v = body.w = {};
  body.force = body.torque = body.user_force = body.user_torque = {};
  body.rest = 0;
  body.rest_X_WB = {body.p, body.q};
  if (body.fixed) body.awake = false;
}

void set_down(WorldState& world, Articulation& it, const Pose& shift) {
  std::fill(it.v.begin(), it.v.end(), 0.0);
  for (AxisState& axis : it.axes) axis.motor = axis.stop = 0;
  // The base moves the rest; joint positions are kept.
  it.mechanism->place(shift * it.poses[0], {}, it.q.data(), it.v.data());
  refresh(it);
  place_bodies(it, world.bodies);
}

}  // namespace

PlaceResult World::place(BodyId id, const Pose& X_WB) {
  WorldState& world = *state_;
  const auto number = static_cast<std::uint32_t>(id);
  assert(number < world.bodies.size());
  Body& body = world.bodies[number];
  Articulation* it = articulation_of(world, number);
  PlaceResult out;
  if (body.left) out.problem = "it has left the arena";
  if (it != nullptr && !it->floating) out.problem = "it is fixed in the world";
  if (!out.problem.empty()) return out;
  const Pose shift = Pose{X_WB.p, normalised(X_WB.q)} * inverse(Pose{body.p, body.q});
  const std::vector<std::uint32_t> bodies = moved_with(world, number);
  out.problem = problem_there(world, bodies, shift, out);
  // Nothing has changed up to here.
  if (!out.problem.empty()) return out;

  std::swap(world.events, world.early);
  for (const std::uint32_t i : bodies) wake(world, i);
  wake_around(world, bodies);
  const auto moved = [&bodies](std::uint32_t i) {
    return std::binary_search(bodies.begin(), bodies.end(), i);
  };
  // Their impulses belong to the place that was left.
  std::erase_if(world.contacts, [&](const Contact& one) { return moved(one.a) || moved(one.b); });
  for (const std::uint32_t i : bodies) {
    end_grasps_of(world, i);
    set_down(world, i, shift * Pose{world.bodies[i].p, world.bodies[i].q});
  }
  if (it != nullptr) set_down(world, *it, shift);
  const Mat3 turn = matrix(normalised(shift.q));
  for (const std::uint32_t i : bodies) carry_magnets(world, i, turn);
  wake_around(world, bodies);
  std::swap(world.events, world.early);
  world.changed = true;
  world.stock.reset();
  return out;
}

}  // namespace stig::physics
