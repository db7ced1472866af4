// SPDX-License-Identifier: MIT
// What several tests of the physical world share.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "physical/block.h"
#include "physical/scenes.h"
#include "physical/world.h"

namespace stig {

/// The paper's block.
inline BlockModel paper_block() {
  Diagnostics diagnostics;
  auto block = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  REQUIRE(block);
  return *block;
}

inline BlockModel without_magnets(BlockModel block) {
  block.body_mass = block.mass();
  block.magnet_offset = 0;
  return block;
}

inline BodyState state(const World& world, std::uint32_t body) { return world.state(BodyId{body}); }

inline void run(World& world, double seconds) {
  const double end = world.time() + seconds;
  while (world.time() < end - 1e-9) REQUIRE(world.step().ok);
}

/// Largest distance of a body from where it was spawned, m.
inline double drift(const World& world, const WorldConfig& config) {
  double most = 0;
  for (std::uint32_t i = 0; i < world.size(); ++i) {
    most = std::max(most, length(state(world, i).X_WB.p - config.bodies[i].X_WB.p));
  }
  return most;
}

/// A world of one body, for laws of motion.
inline WorldConfig single(const BodyDef& def) {
  WorldConfig config;
  config.bodies = {def};
  return config;
}

}  // namespace stig
