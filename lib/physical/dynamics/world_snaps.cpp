// SPDX-License-Identifier: MIT
// Magnets give no sign when blocks snap together, so snapping is read off: they touch, and are
// pressed upon each other by their magnets with more than some force. Half of it is enough to stay
// snapped, so that a blow is no series of events.
#include <algorithm>
#include <iterator>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

/// With which the magnets press the two bodies of a contact upon each other, N.
double pressing_force(const WorldState& world, const Contact& contact) {
  const BodyPair bodies{contact.a, contact.b};
  // Pulls are sorted by bodies, as they come from pairs of owners in rising order.
  const auto before = [](const Pull& pull, const BodyPair& key) { return pull.bodies < key; };
  const auto at = std::lower_bound(world.pulls.begin(), world.pulls.end(), bodies, before);
  if (at == world.pulls.end() || at->bodies != bodies) return 0;
  // Force along the normal, positive when the first is pulled upon the second.
  return -dot(at->force, contact.normal);
}

bool is_snapped(const WorldState& world, const Contact& contact, bool was) {
  // Nothing is computed between sleepers, and nothing changes.
  if (!world.bodies[contact.a].awake && !world.bodies[contact.b].awake) return was;
  const double force = world.config.snap.force;
  return contact.touching && pressing_force(world, contact) >= (was ? force / 2 : force);
}

/// An event for each pair of `in` that is not among `out`.
void report(WorldState& world, EventKind kind, const std::vector<BodyPair>& in,
            const std::vector<BodyPair>& out) {
  std::vector<BodyPair> only;
  std::set_difference(in.begin(), in.end(), out.begin(), out.end(), std::back_inserter(only));
  for (const auto& [a, b] : only) world.events.push_back({kind, BodyId{a}, BodyId{b}});
}

}  // namespace

void report_snaps(WorldState& world) {
  if (world.magnets.empty()) return;
  std::vector<BodyPair> snaps;
  auto before = world.snaps.begin();
  for (const Contact& contact : world.contacts) {
    const BodyPair bodies{contact.a, contact.b};
    while (before != world.snaps.end() && *before < bodies) ++before;
    const bool was = before != world.snaps.end() && *before == bodies;
    if (contact.b != kFloorBody && is_snapped(world, contact, was)) snaps.push_back(bodies);
  }
  report(world, EventKind::let_go, world.snaps, snaps);
  report(world, EventKind::snapped, snaps, world.snaps);
  world.snaps = std::move(snaps);
}

}  // namespace stig::physics
