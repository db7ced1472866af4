// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "urdf/import_robot.h"
#include "urdf/readers.h"
#include "urdf/uses.h"

namespace stig::urdf {

/// The element <world> of an SDF file as a scene: models that are a cube are blocks, others robots,
/// each in a file of its own.
ImportedDescription import_world(const XmlNode& world, const std::string& stem,
                                 const Reading& reading);

}  // namespace stig::urdf
