// SPDX-License-Identifier: MIT
// A rangefinder is one ray without width, as in the simulator whose calibrations it takes; real
// ones average over a cone.
#include "physical/sensors/range_sensor.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sensing/gaussian.h"

namespace stig::physics {

namespace {

/// The floor fills all below z = 0.
std::optional<double> floor_hit(const Vec3& p_W, const Vec3& direction_W) {
  if (p_W.z <= 0) return 0.0;
  if (!(direction_W.z < 0)) return std::nullopt;
  // direction_W is unit, so this is in metres.
  return p_W.z / -direction_W.z;
}

std::optional<double> body_hit(const SensorIndex& index, std::uint32_t i, const Vec3& p_W,
                               const Vec3& direction_W) {
  const SightObstacle& o = index.scene.obstacles[i];
  const auto meets = cut(index.scene.shapes[o.shape], index.axes[i].transposed(p_W - o.X_WS.p),
                         index.axes[i].transposed(direction_W));
  // A line is cut behind its start as well: only what lies ahead counts.
  if (!meets || meets->out < 0) return std::nullopt;
  // Where the ray starts inside a body, the sensor touches it.
  return std::max(meets->in, 0.0);
}

}  // namespace

std::optional<double> closest_hit(const SensorIndex& index, const Vec3& p_W,
                                  const Vec3& direction_W, double range, std::uint32_t owner) {
  assert(range >= 0);
  std::optional<double> closest;
  const auto note = [&](const std::optional<double>& hit) {
    if (hit && *hit <= range && (!closest || *hit < *closest)) closest = hit;
  };
  if (index.scene.floor) note(floor_hit(p_W, direction_W));
  std::vector<std::uint32_t> found;
  // The box about the ray holds every body that it could meet.
  index.obstacles.find(bounds_of({p_W, p_W + direction_W * range}), found);
  for (const std::uint32_t i : found) {
    if (index.scene.obstacles[i].owner != owner) note(body_hit(index, i, p_W, direction_W));
  }
  return closest;
}

double calibrated(const RangeDevice& device, std::optional<double> distance) {
  using Calibration = RangeDevice::Calibration;
  if (!distance) return without_hit(device);
  if (device.calibration == Calibration::metres) return *distance;
  // Decays with distance: near things give large counts.
  const double v = std::exp(-*distance);
  const auto& c = device.coefficients;
  if (device.calibration == Calibration::power) return c[0] * std::pow(v, c[1]);
  return c[0] + v * (c[1] + v * c[2]);
}

double read_range(const SensorIndex& index, const RangeDevice& device, const Pose& X_WB,
                  std::uint32_t owner, const RangeNoise& noise, const NoiseAddress& address) {
  assert(length(device.direction) > 0);
  const Vec3 direction_W = rotate(X_WB.q, normalised(device.direction));
  auto distance = closest_hit(index, X_WB * device.p_B, direction_W, device.range, owner);
  // Noise is drawn only for a hit: without one the device says so, which is not a length that could
  // be blurred.
  if (distance && noise.distance > 0) {
    Random random = noise_stream(address);
    distance = std::clamp(*distance + noise.distance * gaussian(random), 0.0, device.range);
  }
  return calibrated(device, distance);
}

}  // namespace stig::physics
