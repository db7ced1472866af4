// SPDX-License-Identifier: MIT
// Near-field radios. Who hears whom is in physical/sensors/radio_medium.h.
#pragma once

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct RadioDevice {
  std::string name;
  std::size_t body = 0;
  Vec3 p_B;
  double range = 0.02;
};

/// Bytes, any.
using Message = std::string;

struct RadioKind {
  using Device = RadioDevice;
  using Reading = std::vector<Message>;  ///< received since the last step
  struct Devices {
    std::vector<RadioDevice> radios;
  };
  struct Readings {
    std::vector<std::vector<Message>> radios;  ///< received since the last step
  };
  static constexpr const char* key = "radios";
  static constexpr const char* noun = "radio";
  static constexpr const char* doc = "Near-field radios.";
  static constexpr const char* program_key = "simple_radios";
  static constexpr const char* argos_sensor = "simple_radios";
  static constexpr const char* argos_actuator = "simple_radios";
  static auto& devices(auto& robot) { return robot.radios; }
  static auto& readings(auto& readings) { return readings.radios; }
  static const Form& form();
  static RadioDevice read(const FormView& view, DeviceParts& parts);
};

}  // namespace stig::robots
