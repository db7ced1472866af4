// SPDX-License-Identifier: MIT
#include "physical/sensors/sensor_noise.h"

#include <cmath>

namespace stig::physics {

Random noise_stream(const NoiseAddress& address) {
  return {address.seed, address.device, Purpose::sense, address.robot, address.tick};
}

double counted(double speed, const EncoderNoise& noise, Random& random) {
  if (noise.count <= 0) return speed;
  return noise.count * std::floor(speed / noise.count + random.unit());
}

}  // namespace stig::physics
