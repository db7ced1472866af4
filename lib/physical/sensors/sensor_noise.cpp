// SPDX-License-Identifier: MIT
#include "physical/sensors/sensor_noise.h"

namespace stig::physics {

Random noise_stream(const NoiseAddress& address) {
  return {address.seed, address.device, Purpose::sense, address.robot, address.tick};
}

}  // namespace stig::physics
