// SPDX-License-Identifier: MIT
// From what a camera sees to what its robot is told: pixels, errors if asked for, and poses that
// are estimated from those pixels, never the true ones.
#pragma once

#include "physical/sensors/camera_sensor.h"
#include "physical/sensors/sensor_noise.h"
#include "physical/sensors/uses.h"
#include "robots/robot_io.h"

namespace stig::physics {

/// Ids that false tags have: those of the family tag36h11.
inline constexpr std::uint64_t kTagIds = 587;

/// Enabled; `timestamp` and `X_RC` are the caller's. A tag whose pixels allow no pose is not
/// reported. Of noise all but the latency, which Late<CameraReading> is for.
CameraReading read_camera(const SensorScene& scene, const CameraSight& sight,
                          const CameraView& view, const CameraNoise& noise,
                          const NoiseAddress& address);

}  // namespace stig::physics
