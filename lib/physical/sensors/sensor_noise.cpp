// SPDX-License-Identifier: MIT
#include "physical/sensors/sensor_noise.h"

#include <cmath>
#include <numbers>

namespace stig {

Random noise_stream(const NoiseAddress& address) {
  return {address.seed, address.device, Purpose::sense, address.robot, address.tick};
}

double gaussian(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return radius * std::cos(2 * std::numbers::pi * random.unit());
}

}  // namespace stig
