// SPDX-License-Identifier: MIT
// Sleep by islands: bodies that touch, directly or through others, fall asleep together or not at
// all, since one that moves would wake the others at once. What sleeps costs nothing but its place
// in the grid.
#include <algorithm>
#include <cassert>

#include "base/islands.h"
#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

constexpr double kTrembling = 10;  ///< times the limits of speed, for moments

bool mobile(const WorldState& world, std::uint32_t i) {
  return i != kFloorBody && !world.bodies[i].fixed && !world.bodies[i].left;
}

void fall_asleep(WorldState& world, std::uint32_t i) {
  Body& body = world.bodies[i];
  body.awake = false;
  body.v = body.w = {};
  // The velocities of a mechanism are the joints'; bodies only show them.
  if (Articulation* it = articulation_of(world, i)) {
    std::fill(it->v.begin(), it->v.end(), 0.0);
    std::fill(it->motions.begin(), it->motions.end(), Twist{});
  }
  world.changed = true;
  world.events.push_back({EventKind::slept, BodyId{i}, kFloorId});
}

/// Within what the limits of speed allow in the time asked for. A high column trembles faster than
/// that without going anywhere, so its speed is held only to kTrembling times the limit.
bool stays(const Body& body, const SleepRules& rules) {
  const auto below = [](const Vec3& v, double most) { return squared(v) < most * most; };
  return below(body.p - body.rest_X_WB.p, rules.speed * rules.time) &&
         below(body.v, kTrembling * rules.speed) && below(body.w, kTrembling * rules.spin) &&
         angle_of(body.q * conjugate(body.rest_X_WB.q)) < rules.spin * rules.time;
}

}  // namespace

void wake(WorldState& world, std::uint32_t body) {
  assert(body == kFloorBody || body < world.bodies.size());
  const auto rouse = [&world](std::uint32_t i) {
    Body& one = world.bodies[i];
    if (one.awake) return false;
    one.awake = true;
    one.rest = 0;
    world.changed = true;
    world.events.push_back({EventKind::woke, BodyId{i}, kFloorId});
    return true;
  };
  // Along contacts and joints: a whole heap wakes with one of its blocks.
  std::vector<std::uint32_t> todo;
  if (mobile(world, body) && rouse(body)) todo.push_back(body);
  while (!todo.empty()) {
    const std::uint32_t i = todo.back();
    todo.pop_back();
    if (const Articulation* it = articulation_of(world, i)) {
      for (const LinkBody& link : it->links) {
        if (rouse(link.body)) todo.push_back(link.body);
      }
    }
    for (const Contact& contact : world.contacts) {
      if (contact.a != i && contact.b != i) continue;
      const std::uint32_t other = contact.a == i ? contact.b : contact.a;
      if (mobile(world, other) && rouse(other)) todo.push_back(other);
    }
  }
}

void put_to_sleep(WorldState& world) {
  const SleepRules& rules = world.config.sleep;
  if (!rules.enabled) return;
  Islands islands(world.bodies.size());
  for (const Contact& contact : world.contacts) {
    if (mobile(world, contact.a) && mobile(world, contact.b)) islands.join(contact.a, contact.b);
  }
  // A mechanism is one island, whatever its parts touch.
  for (const Articulation& articulation : world.articulations.all) {
    for (const LinkBody& link : articulation.links) {
      islands.join(articulation.links[0].body, link.body);
    }
  }
  std::vector<bool> restless(world.bodies.size(), false);
  for (const std::uint32_t i : world.awake) {
    Body& body = world.bodies[i];
    // A push that lasts must not be slept through.
    const bool pushed = !(body.user_force == Vec3{}) || !(body.user_torque == Vec3{});
    if (stays(body, rules) && !body.free && !pushed) {
      body.rest += world.config.step;
    } else {
      body.rest = 0;
      body.rest_X_WB = {body.p, body.q};
    }
    if (mobile(world, i) && body.rest < rules.time) restless[islands.root(i)] = true;
  }
  for (Articulation& articulation : world.articulations.all) {
    const std::uint32_t root = islands.root(articulation.links[0].body);
    restless[root] = restless[root] || driven(articulation);
  }
  for (const std::uint32_t i : world.awake) {
    if (mobile(world, i) && !restless[islands.root(i)]) fall_asleep(world, i);
  }
}

}  // namespace stig::physics
