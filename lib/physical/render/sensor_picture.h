// SPDX-License-Identifier: MIT
// What a robot's camera sees, as a picture: for people, and for programs that read pictures. Light
// comes from everywhere; bodies are drawn as sensors know them, tags as those of the family
// tag36h11.
#pragma once

#include <array>
#include <optional>

#include "physical/render/raster.h"
#include "physical/render/uses.h"
#include "physical/sensors/sensor_scene.h"
#include "sensing/camera_picture.h"

namespace stig::physics {

/// The cells of a tag's sheet, 10 x 10, row by row from above: true is light. The outermost are
/// its white border.
using TagCells = std::array<bool, 100>;
/// The cells of tag36h11 for the tags of a block, 0 to 5; all light for others.
TagCells tag_cells(int id);
/// What a line of sight meets of the sheet of a tag with this side: light, dark, or nothing.
std::optional<Vec3> sheet_colour(const TagCells& cells, double side, const PlaneHit& hit);

/// What a camera sees. Cylinders and hulls are as good as the scene's shapes; bodies that the
/// camera is in do not hide anything.
CameraPicture camera_picture(const SensorScene& scene, const CameraIntrinsics& camera,
                             const Pose& X_WC, int samples);
/// In whole numbers.
Image whole_numbers(const CameraPicture& picture);

}  // namespace stig::physics
