// SPDX-License-Identifier: MIT
// Extents are those of the pose in the file, with joints at zero: what a compiler has to know
// before anything moves.
#include "robots/robot_extent.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::robots {

BodyExtent extent_of(const BodyModel& body) {
  assert(body.shape != ShapeType::hull || !body.points.empty());
  const Mat3 r = matrix(body.X_RB.q);
  const auto grow = [](BodyExtent& extent, const Vec3& p) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y),
                  std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y),
                   std::max(extent.high.z, p.z)};
  };
  // Far beyond any robot, whose lengths the forms bound by kFar.
  BodyExtent out{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  if (body.shape == ShapeType::hull) {
    for (const Vec3& p : body.points) grow(out, body.X_RB * p);
    return out;
  }
  const Vec3 h = body.size * 0.5;
  // The eight corners, a bit for each sign.
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{(i & 1) ? h.x : -h.x, (i & 2) ? h.y : -h.y, (i & 4) ? h.z : -h.z};
    grow(out, body.X_RB.p + r * corner);
  }
  return out;
}

double radius_of(const BodyModel& body) {
  switch (body.shape) {
    case ShapeType::sphere:
      return body.size.x / 2;
    case ShapeType::cylinder:
      return std::hypot(body.size.x, body.size.z) / 2;
    case ShapeType::box:
      return length(body.size) / 2;
    case ShapeType::hull:
      break;
  }
  double out = 0;
  for (const Vec3& p : body.points) out = std::max(out, length(p));
  return out;
}

BodyExtent extent_of(const RobotModel& robot, const std::vector<bool>& counts) {
  assert(std::find(counts.begin(), counts.end(), true) != counts.end());
  BodyExtent out{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    if (!counts[i]) continue;
    const BodyExtent one = extent_of(robot.bodies[i]);
    out.low = {std::min(out.low.x, one.low.x), std::min(out.low.y, one.low.y),
               std::min(out.low.z, one.low.z)};
    out.high = {std::max(out.high.x, one.high.x), std::max(out.high.y, one.high.y),
                std::max(out.high.z, one.high.z)};
  }
  return out;
}

std::vector<bool> lifted_bodies(const RobotModel& robot) {
  assert(robot.lift);
  std::vector<bool> out(robot.bodies.size(), false);
  out[robot.joints[robot.lift->axis.joint].child] = true;
  // A body is carried by the lift if its parent is. Joints come in any order in a file, hence
  // passes until nothing changes; robots have some dozens of joints at most.
  for (bool more = true; more;) {
    more = false;
    for (const JointModel& joint : robot.joints) {
      if (!out[joint.parent] || out[joint.child]) continue;
      out[joint.child] = more = true;
    }
  }
  return out;
}

Vec3 middle_of_poles(const RobotModel& robot) {
  assert(robot.magnets && !robot.magnets->poles.empty());
  Vec3 out;
  for (const auto& pole : robot.magnets->poles) out += robot.bodies[pole.body].X_RB * pole.p_B;
  return out * (1 / static_cast<double>(robot.magnets->poles.size()));
}

}  // namespace stig::robots
