// SPDX-License-Identifier: MIT
#include "robots/robot_pivot.h"

#include <algorithm>
#include <cassert>

#include "robots/robot_extent.h"

namespace stig::robots {

namespace {

constexpr double kTouching = 0.5e-3;  ///< m over the floor

/// Where a body stands on the floor.
struct Support {
  double x = 0;
  bool wheel = false;  ///< of the drive
  double load = 0;     ///< part of the weight
};

std::vector<Support> supports_of(const RobotModel& robot) {
  std::vector<bool> wheels(robot.bodies.size(), false);
  for (const auto* side : {&robot.drive->left, &robot.drive->right}) {
    for (const AxisRef& axis : *side) wheels[robot.joints[axis.joint].child] = true;
  }
  std::vector<Support> out;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const BodyModel& body = robot.bodies[i];
    if (wheels[i] || extent_of(body).low.z < kTouching) {
      out.push_back({body.X_RB.p.x, wheels[i], 0});
    }
  }
  return out;
}

/// Supports are taken to give way alike, so that loads change linearly along x: with two axles, or
/// an axle and a caster, that is what the lever's law says.
void share_load(double centre, std::vector<Support>& supports) {
  const double count = static_cast<double>(supports.size());
  double mean = 0, squares = 0;
  for (const Support& one : supports) mean += one.x / count;
  for (const Support& one : supports) squares += (one.x - mean) * (one.x - mean);
  const double slope = squares > 1e-9 ? (centre - mean) / squares : 0;
  for (Support& one : supports) one.load = std::max(0.0, 1 / count + slope * (one.x - mean));
}

}  // namespace

double pivot_of(const RobotModel& robot) {
  assert(robot.drive);
  if (robot.drive->left.empty() && robot.drive->right.empty()) return 0;
  std::vector<Support> supports = supports_of(robot);
  share_load(robot.centre_of_mass().x, supports);
  std::erase_if(supports, [](const Support& one) { return !one.wheel; });
  assert(!supports.empty());
  std::sort(supports.begin(), supports.end(),
            [](const Support& a, const Support& b) { return a.x < b.x; });
  double half = 0, before = 0;
  for (const Support& one : supports) half += one.load / 2;
  std::size_t i = 0;
  while (i + 1 < supports.size() && before + supports[i].load < half - 1e-9) {
    before += supports[i++].load;
  }
  // Where one half is borne up to here exactly, any place up to the next wheel is as good.
  const bool even = i + 1 < supports.size() && before + supports[i].load < half + 1e-9;
  return even ? (supports[i].x + supports[i + 1].x) / 2 : supports[i].x;
}

}  // namespace stig::robots
