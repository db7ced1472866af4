// SPDX-License-Identifier: MIT
#include "support/scenes.h"

#include "base/random.h"
#include "support/uses.h"

namespace stig {

namespace {

/// The block of a lattice cell.
BodyDef in_cell(const BlockModel& block, double x, double y, double z) {
  const double pitch = block.side - kInto;
  return block_body(block, {{x * pitch, y * pitch, block.side / 2 - kInto + z * pitch}, {}});
}

}  // namespace

WorldConfig scene_settings(const SceneFriction& friction) {
  WorldConfig config;
  config.friction = friction.blocks;
  config.frictions.push_back({kBlockMaterial, kFloorMaterial, friction.floor});
  return config;
}

WorldConfig column_scene(const BlockModel& block, int height) {
  WorldConfig config = scene_settings();
  for (int z = 0; z < height; ++z) config.bodies.push_back(in_cell(block, 0, 0, z));
  return config;
}

WorldConfig pyramid_scene(const BlockModel& block) {
  WorldConfig config = scene_settings();
  for (int z = 0; z < 3; ++z) {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        // The square, the cross, the middle: at most 2, 1, 0 steps away.
        if (std::abs(x) + std::abs(y) <= 2 - z) config.bodies.push_back(in_cell(block, x, y, z));
      }
    }
  }
  return config;
}

WorldConfig wall_scene(const BlockModel& block, int length, int height) {
  WorldConfig config = scene_settings();
  for (int z = 0; z < height; ++z) {
    for (int x = 0; x < length; ++x) config.bodies.push_back(in_cell(block, x, 0, z));
  }
  return config;
}

WorldConfig drop_scene(const BlockModel& block, std::size_t count) {
  WorldConfig config = scene_settings();
  const double pitch = 1.8 * block.side;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(1, 0, Purpose::start, static_cast<std::uint32_t>(i), 0);
    const auto noise = [&random] { return 2 * random.unit() - 1; };
    const Vec3 cell{static_cast<double>(i % 5) - 2, static_cast<double>(i / 5 % 5) - 2,
                    static_cast<double>(i / 25) + 1};
    const Vec3 shift{noise(), noise(), 0}, turn{noise(), noise(), noise()};
    config.bodies.push_back(block_body(
        block, {cell * pitch + shift * (0.1 * block.side), normalised(rotation(turn * 0.3))}));
  }
  return config;
}

WorldConfig pair_scene(const BlockModel& block, double gap, double friction) {
  WorldConfig config = scene_settings({friction, friction});
  const double x = (block.side + gap) / 2, z = block.side / 2 - kInto;
  config.bodies = {block_body(block, {{-x, 0, z}, {}}), block_body(block, {{x, 0, z}, {}})};
  return config;
}

}  // namespace stig
