// SPDX-License-Identifier: MIT
// What a camera sees of a world: tags and LEDs, without rendering an image.
//
// - A tag is seen when the angle between its normal and the line to the camera is within its
//   limit, all four corners are in the frustum, and no body but those of its own owner hides
//   a corner.
// - An LED is seen when it is lit, within its angle, in the frustum and not hidden.
//
// These are the published rules of the block's simulator (Allwright et al. 2017,
// TR/IRIDIA/2017-003). A reading is made of the pixels alone: see camera_reading.h.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physical/sensors/sensor_scene.h"
#include "physical/sensors/uses.h"
#include "sensing/camera_view.h"

namespace stig::physics {

struct SeenTag {
  std::uint32_t body = 0;  ///< place in SensorScene::marked
  std::uint32_t tag = 0;   ///< of its kind
  std::array<ImagePoint, 4> corners;
};

struct SeenLed {
  std::uint32_t body = 0, led = 0;
  ImagePoint pixel;
};

/// In the order of bodies, and of the marks of a kind.
struct CameraSight {
  std::vector<SeenTag> tags;
  std::vector<SeenLed> leds;
};

/// The camera's frame at X_WC has z ahead, x right and y down.
CameraSight look(const SensorIndex& index, const CameraView& view, const Pose& X_WC);

}  // namespace stig::physics
