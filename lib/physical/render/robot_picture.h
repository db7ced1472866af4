// SPDX-License-Identifier: MIT
// A picture of a robot: its bodies, the frames of its joints and cameras, what cameras see, how
// far rangefinders and radios reach.
#pragma once

#include <string>

#include "physical/render/solid_faces.h"
#include "physical/render/uses.h"
#include "robots/robot_model.h"

namespace stig::physics {

/// The faces of a body as its file has it, cylinders and hulls too; body frame.
std::vector<SolidFace> faces_of(const BodyModel& body);

/// A PNG file; empty when there is no memory for it.
std::string robot_png(const RobotModel& robot);
/// A binary glTF file: a node for each body under the one whose joint carries it, y up, and the
/// lines of the picture.
std::string robot_glb(const RobotModel& robot);

}  // namespace stig::physics
