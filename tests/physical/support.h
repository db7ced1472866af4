// SPDX-License-Identifier: MIT
// What several tests of the physical world share.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "physical/dynamics/world.h"
#include "physical/trials.h"
#include "robots/block.h"
#include "support/scenes.h"
#include "support/uses.h"

namespace stig {

/// The paper's block.
inline BlockModel paper_block() {
  Diagnostics diagnostics;
  auto block = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  REQUIRE(block);
  return *block;
}

inline BodyState state(const World& world, std::uint32_t body) { return world.state(BodyId{body}); }

inline void run(World& world, double seconds) {
  const double end = world.time() + seconds;
  while (world.time() < end - 1e-9) REQUIRE(world.step().ok);
}

/// Events of the last step.
inline std::size_t count(const World& world, EventKind kind) {
  return static_cast<std::size_t>(
      std::count_if(world.events().begin(), world.events().end(),
                    [kind](const WorldEvent& event) { return event.kind == kind; }));
}

/// A world of one body, for laws of motion.
inline WorldConfig single(const BodyDef& def) {
  WorldConfig config;
  config.bodies = {def};
  return config;
}

}  // namespace stig
