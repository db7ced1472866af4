// SPDX-License-Identifier: MIT
// Joints' axes that the controller drives itself, each under a name.
#pragma once

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct ActuatorDevice {
  std::string name;
  AxisRef axis;
};

struct JointReading {
  double position = 0, velocity = 0;  ///< rad or m, and a second

  static void fields(auto&& each, auto& reading) {
    each("position", reading.position, ""), each("velocity", reading.velocity, "");
  }
};

struct ActuatorKind {
  using Device = ActuatorDevice;
  using Reading = JointReading;
  struct Devices {
    std::vector<ActuatorDevice> actuators;
  };
  struct Readings {
    std::vector<JointReading> joints;  ///< of the file's free actuators
  };
  static constexpr const char* key = "actuators";
  static constexpr const char* noun = "actuator";
  static constexpr const char* doc = "Other axes, for the program to drive.";
  static constexpr const char* program_key = "joints";
  static auto& devices(auto& robot) { return robot.actuators; }
  static auto& readings(auto& readings) { return readings.joints; }
  static const Form& form();
  static ActuatorDevice read(const FormView& view, DeviceParts& parts);
};

}  // namespace stig::robots
