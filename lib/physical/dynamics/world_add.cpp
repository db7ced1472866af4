// SPDX-License-Identifier: MIT
// Bodies that come into a world that runs.
#include <fmt/format.h>

#include <algorithm>

#include "physical/dynamics/world_state.h"

namespace stig::physics {

namespace {

/// The addition as a world of its own, under this one's settings: it is checked by itself, then
/// against what is there.
WorldConfig alone(const WorldState& world, const Addition& addition) {
  WorldConfig config = world.config;
  config.bodies = addition.bodies;
  config.joints = addition.joints;
  return config;
}

// All against all: additions are single blocks or robots, and rare.
void find_overlap(const WorldState& world, const Addition& addition, AddResult& out) {
  for (std::size_t i = 0; i < addition.bodies.size(); ++i) {
    const BodyDef& def = addition.bodies[i];
    for (std::size_t k = 0; k < world.bodies.size(); ++k) {
      const Body& other = world.bodies[k];
      if (other.left || (other.fixed && def.fixed)) continue;
      if (spawns_overlap(def.shape, def.X_WB, other.shape, {other.p, other.q})) {
        out.problem = fmt::format("body {} overlaps body {} of the world", i, k);
        out.overlaps = true;
        out.other = BodyId{static_cast<std::uint32_t>(k)};
        return;
      }
    }
  }
}

std::string problem_with(const WorldState& world, const Addition& addition) {
  const std::vector<std::string> problems = problems_of(alone(world, addition));
  if (!problems.empty()) return problems[0];
  if (world.bodies.size() + addition.bodies.size() > kMostBodies) {
    return "there may be at most 20000 bodies";
  }
  double least = 1e9, most = 0;
  for (const auto* bodies : {&world.config.bodies, &addition.bodies}) {
    for (const BodyDef& def : *bodies) {
      least = std::min(least, def.shape.radius());
      most = std::max(most, def.shape.radius());
    }
  }
  // The grid of the broad phase is made for sizes within this ratio.
  if (most > kMostSizeRatio * least) return "the largest body is more than 200 times the smallest";
  return {};
}

}  // namespace

AddResult World::add(const Addition& addition) {
  AddResult out;
  out.problem = problem_with(*state_, addition);
  if (out.problem.empty()) find_overlap(*state_, addition, out);
  if (!out.problem.empty()) return out;
  const auto first = static_cast<std::uint32_t>(state_->bodies.size());
  out.body = BodyId{first};
  out.joint = JointId{static_cast<std::uint32_t>(state_->config.joints.size())};
  std::vector<JointDef> joints = addition.joints;
  // Numbers in an addition count from its own first body.
  for (JointDef& joint : joints) {
    joint.child += first;
    if (joint.parent != kWorldBody) joint.parent += first;
  }
  append(*state_, addition.bodies, joints);
  return out;
}

}  // namespace stig::physics
