// SPDX-License-Identifier: MIT
#include <algorithm>

#include "physical/world_state.h"

namespace stig {

namespace {

/// With which the magnets press b upon a, N.
double pressing_force(const WorldState& world, const Contact& contact) {
  const BodyPair bodies{contact.a, contact.b};
  const auto before = [](const Pull& pull, const BodyPair& key) { return pull.bodies < key; };
  const auto at = std::lower_bound(world.pulls.begin(), world.pulls.end(), bodies, before);
  if (at == world.pulls.end() || at->bodies != bodies) return 0;
  return -dot(at->force, contact.normal);
}

bool is_snapped(const WorldState& world, const Contact& contact) {
  const bool was =
      std::binary_search(world.snaps.begin(), world.snaps.end(), BodyPair{contact.a, contact.b});
  // Nothing is computed between sleepers, and nothing changes.
  if (!world.bodies[contact.a].awake && !world.bodies[contact.b].awake) return was;
  const double force = world.config.snap.force;
  return contact.touching && pressing_force(world, contact) >= (was ? force / 2 : force);
}

}  // namespace

void report_snaps(WorldState& world) {
  std::vector<BodyPair> snaps;
  for (const Contact& contact : world.contacts) {
    if (contact.b == kFloorBody || !is_snapped(world, contact)) continue;
    snaps.emplace_back(contact.a, contact.b);
  }
  const auto report = [&world](EventKind kind, const std::vector<BodyPair>& in,
                               const std::vector<BodyPair>& out) {
    for (const auto& [a, b] : in) {
      if (std::binary_search(out.begin(), out.end(), BodyPair{a, b})) continue;
      world.events.push_back({kind, BodyId{a}, BodyId{b}});
    }
  };
  report(EventKind::let_go, world.snaps, snaps);
  report(EventKind::snapped, snaps, world.snaps);
  world.snaps = std::move(snaps);
}

}  // namespace stig
