// SPDX-License-Identifier: MIT
#include "compiler/abilities.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig {

namespace {

constexpr double kGravity = 9.8;
constexpr double kDipoleForce = 6e-7;  ///< N m⁴/(A m²)²: 6 μ0/4π, two aligned dipoles on an axis

/// A body's extent along the robot's axes, every joint at zero.
struct Extent {
  Vec3 low, high;
};

Extent extent_of(const BodyModel& body) {
  const Mat3 r = matrix(body.X_RB.q);
  const auto grow = [](Extent& extent, const Vec3& p) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y),
                  std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y),
                   std::max(extent.high.z, p.z)};
  };
  Extent out{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  if (body.shape == ShapeType::hull) {
    for (const Vec3& p : body.points) grow(out, body.X_RB * p);
    return out;
  }
  // Exact for a box; round shapes count as the box about them.
  const Vec3 h = body.size * 0.5;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{(i & 1) ? h.x : -h.x, (i & 2) ? h.y : -h.y, (i & 4) ? h.z : -h.z};
    grow(out, body.X_RB.p + r * corner);
  }
  return out;
}

/// Which bodies go up with the lift.
std::vector<bool> lifted_bodies(const RobotModel& robot) {
  std::vector<bool> out(robot.bodies.size(), false);
  out[robot.joints[robot.lift->axis.joint].child] = true;
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
  Vec3 out;
  for (const auto& pole : robot.magnets->poles) out += robot.bodies[pole.body].X_RB * pole.p_B;
  return out * (1 / static_cast<double>(robot.magnets->poles.size()));
}

/// The force of four aligned pairs at a gap between faces.
double face_force(const BlockFigures& block, double gap) {
  const double distance = block.look.side - 2 * block.magnet_offset + gap;
  return 4 * kDipoleForce * block.magnet_moment * block.magnet_moment / std::pow(distance, 4);
}

/// The gap at which the magnets' pull is the floor's friction on a block.
double reach_of(const BlockFigures& block) {
  const double friction = block.floor_friction * block.mass * kGravity;
  double low = 0, high = 0.04;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (face_force(block, middle) > friction ? low : high) = middle;
  }
  return low;
}

/// Bodies over the carried block are the effector, the rest stands behind it.
void measure_bodies(const RobotModel& robot, Abilities& out) {
  const std::vector<bool> lifted = lifted_bodies(robot);
  const double half = out.block.side / 2;
  double underside = 1e9;
  out.body_front = out.body_back = out.body_half_width = out.effector_front =
      out.effector_half_width = 0;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const Extent extent = extent_of(robot.bodies[i]);
    const double width = std::max(extent.high.y, -extent.low.y);
    const bool over = lifted[i] && extent.high.x > out.carried_x - half / 2 &&
                      extent.low.x < out.carried_x + half / 2;
    if (over) {
      out.effector_front = std::max(out.effector_front, extent.high.x);
      out.effector_half_width = std::max(out.effector_half_width, width);
      underside = std::min(underside, extent.low.z);
    } else {
      out.body_front = std::max(out.body_front, extent.high.x);
      out.body_back = std::max(out.body_back, -extent.low.x);
      if (!lifted[i]) out.body_half_width = std::max(out.body_half_width, width);
    }
  }
  out.lowest = underside - out.block.side;
  out.levels = 0;
  while (out.lift_for(out.levels) <= out.lift_travel) ++out.levels;
}

}  // namespace

std::vector<std::string> lacking(const RobotModel& robot) {
  std::vector<std::string> out;
  if (!robot.drive) out.emplace_back("it has no differential drive");
  if (!robot.lift) out.emplace_back("it has no lift");
  if (!robot.magnets || robot.magnets->poles.empty()) {
    out.emplace_back("it has no electromagnets to hold a block with");
  }
  if (robot.cameras.empty()) out.emplace_back("it has no camera");
  if (robot.radios.empty()) out.emplace_back("it has no radio to set a block's colour with");
  return out;
}

Abilities abilities_of(const RobotModel& robot, const BlockFigures& block) {
  assert(lacking(robot).empty());
  Abilities out;
  out.block = block.look;
  out.block_weight = block.mass * kGravity;
  out.lift_travel = robot.lift->high;
  out.carried_x = middle_of_poles(robot).x;
  out.magnet_reach = reach_of(block);
  out.face_hold = face_force(block, 0);
  out.friction = block.block_friction;
  measure_bodies(robot, out);
  const std::vector<bool> lifted = lifted_bodies(robot);
  for (const CameraDevice& camera : robot.cameras) {
    out.cameras.push_back({camera.intrinsics, robot.bodies[camera.body].X_RB * camera.X_BC,
                           camera.near, camera.far, lifted[camera.body]});
  }
  return out;
}

}  // namespace stig
