// SPDX-License-Identifier: MIT
// Effector and block are at the same place while it holds, so ways of blocks are ways of the
// effector, and the robot's own shape does not come into it.
#include "validate/ideal_time.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::validate {
namespace {

double level_way(const Vec3& from, const Vec3& to) {
  return std::hypot(to.x - from.x, to.y - from.y);
}

/// Another one took its place later.
bool replaced(std::span<const Haul> hauls, const Haul& haul) {
  return std::any_of(hauls.begin(), hauls.end(), [&](const Haul& other) {
    return other.placed == haul.placed && other.structure == haul.structure &&
           other.from > haul.from;
  });
}

}  // namespace

WorkSpeeds work_speeds(const RobotModel& robot) {
  if (!robot.drive || !robot.lift || robot.lift->speeds.empty()) return {};
  // Speeds of the lift stand in falling order of errors, and the longest way is the fastest.
  return {robot.drive->most_speed / 2, robot.drive->most_acceleration,
          robot.lift->speeds.front().second};
}

double straight_time(double way, const WorkSpeeds& speeds) {
  assert(way >= 0 && speeds.cruise > 0 && speeds.acceleration > 0);
  const double ramps = speeds.cruise * speeds.cruise / speeds.acceleration;
  // Too short to reach the cruising speed: faster for one half, slower for the other.
  if (way < ramps) return 2 * std::sqrt(way / speeds.acceleration);
  return way / speeds.cruise + speeds.cruise / speeds.acceleration;
}

double ideal_time(std::span<const Haul> hauls, std::size_t robot, const Vec3& hand,
                  const WorkSpeeds& speeds) {
  if (!(speeds.cruise > 0 && speeds.acceleration > 0 && speeds.lift > 0)) return 0;
  double time = 0;
  Vec3 at = hand;
  for (const Haul& haul : hauls) {
    if (haul.robot != robot || !haul.placed || replaced(hauls, haul)) continue;
    const double rise = std::max(0.0, haul.put.z - haul.taken.z) + kPassingHeight;
    time += straight_time(level_way(at, haul.taken), speeds) + kAttachTime +
            std::max(straight_time(level_way(haul.taken, haul.put), speeds), rise / speeds.lift) +
            kPassingHeight / speeds.lift + kReleaseTime;
    at = haul.put;
  }
  return time;
}

}  // namespace stig::validate
