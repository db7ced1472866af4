// SPDX-License-Identifier: MIT
// Joints between bodies: any mix of linear and angular degrees of freedom, with stops,
// motors and viscous friction. Bodies that joints connect are a mechanism: a tree whose
// links do not collide with each other, and which sleeps and wakes as one.
//
// A joint's frame J stands at X_PJ in the parent and at X_CJ in the child. Where all its
// positions are 0 the two agree; else the child's frame is moved by each degree of freedom
// in turn, about or along axes that the earlier ones have moved: three angular ones about z,
// y, x make a ball that is good until the second comes near a right angle. None at all: the
// bodies are one rigid piece.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/vec.h"
#include "physical/dynamics/uses.h"

namespace stig::physics {

/// What moves a degree of freedom, besides what touches the bodies.
enum class Actuator : std::uint8_t {
  none,
  velocity,  ///< keeps the target velocity, with at most `effort`
  position,  ///< goes to the target position, at most at `speed`, with at most `effort`
  force,     ///< applies the target, within ±`effort`
};

struct DofDef {
  bool linear = false;                                      ///< along the axis; otherwise about it
  Vec3 axis{0, 0, 1};                                       ///< unit, in the joint's frame
  double start = 0;                                         ///< position at the beginning, m or rad
  double start_speed = 0;                                   ///< m/s or rad/s
  double lower = -std::numeric_limits<double>::infinity();  ///< m or rad
  double upper = std::numeric_limits<double>::infinity();
  Actuator actuator = Actuator::none;
  double effort = 10;  ///< most force or torque of the actuator, N or N·m
  double speed = 1;    ///< of a position actuator, m/s or rad/s
  double damping = 0;  ///< N·s/m or N·m·s/rad
};

/// The parent of a joint that hangs in the world.
inline constexpr std::uint32_t kWorldBody = 0xffffffff;

struct JointDef {
  std::uint32_t parent = kWorldBody, child = 0;  ///< places in WorldConfig::bodies
  Pose X_PJ, X_CJ;
  std::vector<DofDef> dofs;
};

/// Pose of the child in the parent's frame at the start.
Pose start_pose(const JointDef& joint);

struct WorldConfig;

/// Puts every child where its joints say, from the bodies that are no children on; with
/// velocities. For those who write configurations.
void place_links(WorldConfig& config);

/// For each body the smallest body of its mechanism, or itself. Of sound joints.
std::vector<std::uint32_t> mechanisms_of(const WorldConfig& config);

/// What makes the joints unusable: cycles, two parents, bodies that do not meet, and so on.
/// Empty where there are none.
std::vector<std::string> problems_of_joints(const WorldConfig& config);

}  // namespace stig::physics
