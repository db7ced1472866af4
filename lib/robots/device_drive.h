// SPDX-License-Identifier: MIT
// The differential drive: wheels left and right. robot_devices.h has its ramp.
#pragma once

#include <optional>

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct DriveModel {
  std::vector<AxisRef> left, right;  ///< wheels, positive forwards
  double wheel_radius = 0, track = 0;
  double most_speed = 0, most_acceleration = 0;  ///< of the rims, m/s and m/s²
};

struct DriveKind {
  using Model = DriveModel;
  struct Devices {
    std::optional<DriveModel> drive;
  };
  struct Readings {
    double left_encoder = 0, right_encoder = 0;  ///< m/s, of the wheels' rims
  };
  static constexpr const char* key = "differential_drive";
  static constexpr const char* doc = "Wheels left and right.";
  static constexpr const char* argos_sensor = "builderbot_differential_drive";
  static constexpr const char* argos_actuator = "builderbot_differential_drive";
  static auto& devices(auto& robot) { return robot.drive; }
  static void reading_members(auto& each, auto& readings) {
    each(readings.left_encoder), each(readings.right_encoder);
  }
  static const Form& form();
  static DriveModel read(const FormView& view, DeviceParts& parts);
  static std::string description(const RobotModel& robot);
};

}  // namespace stig::robots
