// SPDX-License-Identifier: MIT
#include "physical/let_down.h"

#include <algorithm>

#include "base/random.h"
#include "support/uses.h"

namespace stig {

namespace {

constexpr double kSettled = 3;  ///< s, after which nothing moves any more

/// The block's place is the origin's column; the robot comes from +x, the column stands at +y.
std::vector<Vec3> cells_about(Surroundings where) {
  std::vector<Vec3> out = {{0, 1, 0}, {0, 1, 1}};
  if (where != Surroundings::floor_beside) out.push_back({-1, 0, 0});
  if (where != Surroundings::top_beside_behind) return out;
  out.insert(out.end(), {{0, 0, 0}, {0, 1, 2}, {-1, 0, 1}});
  return out;
}

WorldConfig standing(const BlockModel& block, Surroundings where, const SceneFriction& friction) {
  WorldConfig out = scene_settings(friction);
  const double pitch = block.side - kInto;
  for (const Vec3 cell : cells_about(where)) {
    const Vec3 up{0, 0, block.side / 2 - kInto};
    out.bodies.push_back(block_body(block, {cell * pitch + up, {}}));
  }
  return out;
}

}  // namespace

std::vector<LetDown> let_down_aside(const BlockModel& block, Surroundings where, double aside,
                                    const SceneFriction& friction, int trials) {
  const WorldConfig about = standing(block, where, friction);
  const bool behind = where != Surroundings::floor_beside;
  const double pitch = block.side - kInto;
  const double level = where == Surroundings::top_beside_behind ? 1 : 0;
  std::vector<LetDown> out;
  for (int trial = 0; trial < trials; ++trial) {
    Random random(static_cast<std::uint64_t>(trial), 0, Purpose::start, 0, 0);
    const auto noise = [&random] { return 2 * random.unit() - 1; };
    WorldConfig config = about;
    const double ahead = behind ? 1e-3 + 4e-3 * random.unit() : 1e-3 * noise();
    const Vec3 at{ahead, -aside + 1e-3 * noise(),
                  level * pitch + block.side / 2 + 1e-3 + 3e-3 * random.unit()};
    config.bodies.push_back(block_body(block, {at, rotation({0, 0, 2 * kDegree * noise()})}));
    World world(config);
    run_for(world, config, kSettled);
    // Its place is said by the column beside, wherever that was drawn to.
    const auto last = static_cast<std::uint32_t>(config.bodies.size() - 1);
    const Misfit end =
        misfit(world.state(BodyId{level > 0 ? 1U : 0U}).X_WB, world.state(BodyId{last}).X_WB);
    // Without a block behind nothing says how far ahead its place is.
    const double x = end.p.x, y = end.p.y + pitch;
    out.push_back({std::hypot(x, y, end.p.z), std::abs(end.yaw)});
  }
  std::sort(out.begin(), out.end(),
            [](const LetDown& a, const LetDown& b) { return a.way < b.way; });
  return out;
}

}  // namespace stig
