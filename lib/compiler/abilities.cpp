// SPDX-License-Identifier: MIT
// Derives from the robot's and the block's files the few figures that decide what can be
// built. Magnets are taken for dipoles: the force of two aligned ones at distance d is 6
// (mu0/4 pi) m^2 / d^4, an approximation that is best at a distance. All geometry is read
// from bodies' extents, so a changed robot needs no change here.
#include "compiler/abilities.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "robots/robot_extent.h"

namespace stig::compiler {

namespace {

constexpr double kGravity = 9.8;
constexpr double kDipoleForce = 6e-7;  ///< N m⁴/(A m²)²: 6 μ0/4π, two aligned dipoles on an axis

/// The force of four aligned pairs at a gap between faces. Four magnets near the corners of
/// a face attract their counterparts across the gap, and ignore them beyond their cutoff.
double face_force(const BlockFigures& block, double gap) {
  const double distance = block.look.side - 2 * block.magnet_offset + gap;
  if (distance > block.magnet_cutoff) return 0;
  return 4 * kDipoleForce * block.magnet_moment * block.magnet_moment / std::pow(distance, 4);
}

/// The gap at which the magnets' pull is the floor's friction on a block. A loose block
/// slides into place as long as the pull exceeds the friction of the floor. Bisection over
/// 4 cm; the force falls monotonically.
double reach_of(const BlockFigures& block) {
  const double friction = block.floor_friction * block.mass * kGravity;
  double low = 0, high = 0.04;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (face_force(block, middle) > friction ? low : high) = middle;
  }
  return low;
}

/// Bodies over the carried block are the effector, the rest stands behind it. What is
/// lifted together with the block and lies over it can stand above a structure; everything
/// else is a part of the body, which needs free cells (approach.h).
void measure_bodies(const RobotModel& robot, Abilities& out) {
  const std::vector<bool> lifted = lifted_bodies(robot);
  const double half = out.block.side / 2;
  double underside = 1e9;
  out.body_front = out.body_back = out.body_half_width = out.effector_front =
      out.effector_half_width = 0;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const BodyExtent extent = extent_of(robot.bodies[i]);
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
  // Without anything over the block nothing carries it.
  const bool carries = underside < 1e9;
  out.lowest = carries ? underside - out.block.side : 0;
  // A level counts if the lift raises a block over its bricks with some clearance.
  out.levels = 0;
  while (carries && out.lift_for(out.levels) <= out.lift_travel) ++out.levels;
}

}  // namespace

/// All that is missing is listed, so that a robot's author sees it at once.
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
  assert(block.look.side > 0);
  Abilities out;
  out.block = block.look;
  out.block_weight = block.mass * kGravity;
  out.lift_travel = robot.lift->high;
  out.carried_x = middle_of_poles(robot).x;
  out.magnet_reach = reach_of(block);
  out.face_hold = face_force(block, 0);
  out.friction = block.block_friction;
  out.answers = block.answers;
  measure_bodies(robot, out);
  const std::vector<bool> lifted = lifted_bodies(robot);
  for (const CameraDevice& camera : robot.cameras) {
    out.cameras.push_back({camera.intrinsics, robot.bodies[camera.body].X_RB * camera.X_BC,
                           camera.near, camera.far, lifted[camera.body]});
  }
  return out;
}

}  // namespace stig::compiler
