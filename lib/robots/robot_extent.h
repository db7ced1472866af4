// SPDX-License-Identifier: MIT
// How far a robot's parts reach, with every joint at zero: what compiler and programs need to know
// of its shape.
#pragma once

#include <vector>

#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

/// A box along the axes of frame R about a body.
struct BodyExtent {
  Vec3 low, high;
};
/// Boxes and hulls exactly; round shapes by the box about them.
BodyExtent extent_of(const BodyModel& body);

/// The radius of the smallest ball about a body's centre that contains its shape, m.
double radius_of(const BodyModel& body);

/// The box about all bodies of which `counts` says so; there has to be one.
BodyExtent extent_of(const RobotModel& robot, const std::vector<bool>& counts);
/// For each body, whether it goes up with the lift. Of a robot that has one.
std::vector<bool> lifted_bodies(const RobotModel& robot);

/// The middle of the electromagnets' poles, frame R. Of a robot that has some.
Vec3 middle_of_poles(const RobotModel& robot);

}  // namespace stig::robots
