// SPDX-License-Identifier: MIT
// Measures of a robot as a builder. What goes up with the lift and lies over the carried block can
// stand over a structure; all else needs cells that are free.
#include "recheck/figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "robots/robot_extent.h"

namespace stig::recheck {

namespace {

constexpr double kClearance = 0.003;  ///< over what a block is let down on
constexpr int kMostLevels = 64;

/// The widest gap at which four pairs of dipoles, each on one axis, pull a block over the floor:
/// 4 · 6 (μ0/4π) m² / d⁴ = friction, solved for d, as far as magnets do not ignore each other.
double closed_gap(const BlockModel& block) {
  if (!block.has_magnets()) return 0;
  const double within = block.side - 2 * block.magnet_offset;
  const double most = std::clamp(block.magnet_cutoff - within, 0.0, 0.04);
  const double moment = block.magnet_moment(), friction = block.friction * block.mass() * 9.8;
  if (friction <= 0) return most;
  const double distance = std::pow(24e-7 * moment * moment / friction, 0.25);
  return std::clamp(distance - within, 0.0, most);
}

}  // namespace

bool Figures::reaches(int level) const {
  return level * side + kClearance - lowest_bottom <= lift_travel;
}

int Figures::levels() const {
  int out = 0;
  while (out < kMostLevels && reaches(out)) ++out;
  return out;
}

int Figures::rows_beside() const {
  const double beyond = (body_half_width - side / 2) / side;
  return beyond <= 1e-9 ? 0 : static_cast<int>(std::ceil(beyond - 1e-9));
}

Figures figures_of(const RobotModel& robot, const BlockModel& block) {
  assert(robot.lift && robot.magnets && block.side > 0);
  Figures out;
  out.side = block.side;
  out.tag_side = block.tags.side;
  out.tag_proud = block.tags.proud;
  out.led_place = block.leds.offset;
  out.widest = std::min(block.tags.widest, block.leds.widest);
  out.lift_travel = robot.lift->high;
  out.carried_x = middle_of_poles(robot).x;
  out.magnets_close = closed_gap(block);
  const std::vector<bool> lifted = lifted_bodies(robot);
  double underside = HUGE_VAL;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    const BodyExtent box = extent_of(robot.bodies[i]);
    const double half_width = std::max(box.high.y, -box.low.y);
    // Over the block: within a quarter of its length of its middle.
    if (lifted[i] &&
        std::max(box.low.x - out.carried_x, out.carried_x - box.high.x) < block.side / 4) {
      out.effector_front = std::max(out.effector_front, box.high.x);
      out.effector_half_width = std::max(out.effector_half_width, half_width);
      underside = std::min(underside, box.low.z);
      continue;
    }
    out.body_front = std::max(out.body_front, box.high.x);
    out.body_back = std::max(out.body_back, -box.low.x);
    if (!lifted[i]) out.body_half_width = std::max(out.body_half_width, half_width);
  }
  out.lowest_bottom = underside - block.side;
  for (const CameraDevice& camera : robot.cameras) {
    out.eyes.push_back({camera.intrinsics, robot.bodies[camera.body].X_RB * camera.X_BC,
                        camera.near, camera.far, lifted[camera.body]});
  }
  return out;
}

}  // namespace stig::recheck
