// SPDX-License-Identifier: MIT
// Scenes of blocks alone, shared by tests and benchmarks.
//
// Blocks of structures are spawned a little into their support and their neighbours, as they
// would lie after coming to rest.
#pragma once

#include <cstddef>

#include "physical/dynamics/world_config.h"
#include "support/uses.h"

namespace stig {

inline constexpr double kInto = 10e-6;  ///< m, that neighbours overlap at the start

/// Friction of the materials here: block on block, block on floor. The paper has 0.5
/// everywhere; with 0.15 between blocks, magnets align one that lands 4 mm and 5 degrees off
/// within a millimetre and a degree, which they no longer do with 0.2.
struct SceneFriction {
  double blocks = 0.15, floor = 0.4;
};

/// Default settings with these coefficients, and no bodies.
WorldConfig scene_settings(const SceneFriction& friction = {});

/// Blocks one upon the other.
WorldConfig column_scene(const BlockModel& block, int height);
/// Nine blocks in a square, five in a cross upon them, one on top: 15, as in the paper.
WorldConfig pyramid_scene(const BlockModel& block);
/// A wall, one block thick; columns stand face to face.
WorldConfig wall_scene(const BlockModel& block, int length, int height);
/// Blocks that fall from a loose, slightly turned grid of layers of 5 by 5.
WorldConfig drop_scene(const BlockModel& block, std::size_t count);
/// Two blocks on the floor, `gap` metres between their faces.
WorldConfig pair_scene(const BlockModel& block, double gap, double friction);

}  // namespace stig
