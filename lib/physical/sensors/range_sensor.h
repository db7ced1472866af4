// SPDX-License-Identifier: MIT
// Rangefinders: how far along a ray the nearest thing is that is not the robot itself, and
// what the device makes of it.
#pragma once

#include <optional>

#include "physical/sensors/sensor_noise.h"
#include "physical/sensors/sensor_scene.h"
#include "physical/sensors/uses.h"
#include "robots/robot_model.h"

namespace stig::physics {

/// Metres to the nearest body that is not the owner's, or the floor; 0 when the ray starts inside
/// one. Nothing within `range`: nothing. `direction_W` is unit.
std::optional<double> closest_hit(const SensorIndex& index, const Vec3& p_W,
                                  const Vec3& direction_W, double range, std::uint32_t owner);

/// In the device's unit. Counts: a · v^b or c0 + c1 v + c2 v² with v = exp(-distance in m), and
/// 0 without a hit (the calibrations that were published with the simulator of Allwright et al.
/// 2017). Metres: the distance, and the device's range without a hit.
double calibrated(const RangeDevice& device, std::optional<double> distance);

/// Both, with noise. X_WB is of the device's body. Of noise all but the latency, see Late.
double read_range(const SensorIndex& index, const RangeDevice& device, const Pose& X_WB,
                  std::uint32_t owner, const RangeNoise& noise, const NoiseAddress& address);

}  // namespace stig::physics
