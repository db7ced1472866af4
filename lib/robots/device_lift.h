// SPDX-License-Identifier: MIT
// The lift: a joint that goes to a set height. robot_devices.h has its way there.
#pragma once

#include <optional>
#include <utility>

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct LiftModel {
  AxisRef axis;
  double low = 0, high = 0;   ///< m: where the limit switches close
  double tolerance = 0;       ///< error at which it rests
  double inactive_below = 0;  ///< error under which it reports that it has arrived
  /// Speed by error: the first entry whose error is exceeded; in falling order of errors.
  std::vector<std::pair<double, double>> speeds;
};

struct LiftReading {
  bool active = false;  ///< moving towards a set position
  bool calibrating = false;
  double position = 0;
  bool at_top = false, at_bottom = false;  ///< limit switches
};

struct LiftKind {
  using Model = LiftModel;
  struct Devices {
    std::optional<LiftModel> lift;
  };
  struct Readings {
    LiftReading lift;
  };
  static constexpr const char* key = "lift";
  static constexpr const char* doc = "A joint that goes to a set height.";
  static constexpr const char* argos_sensor = "builderbot_lift_system";
  static constexpr const char* argos_actuator = "builderbot_lift_system";
  static auto& devices(auto& robot) { return robot.lift; }
  static void reading_members(auto& each, auto& readings) {
    auto& lift = readings.lift;
    each(lift.active), each(lift.calibrating), each(lift.position);
    each(lift.at_top), each(lift.at_bottom);
  }
  static const Form& form();
  static LiftModel read(const FormView& view, DeviceParts& parts);
  /// The foremost of what it lifts as well.
  static std::string description(const RobotModel& robot);
};

}  // namespace stig::robots
