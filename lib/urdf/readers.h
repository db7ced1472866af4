// SPDX-License-Identifier: MIT
// The two formats. What is wrong or has no counterpart is said, and reading goes on.
#pragma once

#include <string>
#include <vector>

#include "urdf/description.h"
#include "urdf/uses.h"

namespace stig::urdf {

/// The element <robot> of a URDF file.
Description read_urdf(const XmlNode& robot, const Reading& reading);

/// The element <model> of an SDF file; `fixed`: it is told to be static.
struct SdfModel {
  Description robot;
  bool fixed = false, ground = false;
  Pose X_WM;
  std::optional<double> ground_friction;
};
SdfModel read_sdf_model(const XmlNode& model, const Reading& reading);

/// More links or joints than any robot here has: said, and nothing else is read.
bool too_many(const XmlNode& robot, const Reading& reading);

/// The geometry of a <collision> or <visual> in either format; nothing with an error, or of a
/// picture a warning, where robot files have no such shape.
std::optional<Solid> make_solid(ShapeType shape, const Vec3& size, const SourceRange& place,
                                const Reading& reading);

}  // namespace stig::urdf
