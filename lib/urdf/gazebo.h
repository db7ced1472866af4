// SPDX-License-Identifier: MIT
// What URDF borrows from SDF by <gazebo>, and SDF has itself: sensors and plugins.
#pragma once

#include "urdf/description.h"
#include "urdf/uses.h"

namespace stig::urdf {

/// x y z roll pitch yaw, as <pose> has it; the identity where there is none.
Pose pose_of(const XmlNode& node, const Reading& reading);

/// A camera, or a ray alone; others are left out. The element's own pose is in the link's frame.
void read_sensor(const XmlNode& sensor, std::size_t link, const Pose& X_LS, Description& robot,
                 const Reading& reading);
/// A drive of two sides; others are left out.
void read_plugin(const XmlNode& plugin, Description& robot, const Reading& reading);

}  // namespace stig::urdf
