// SPDX-License-Identifier: MIT
// Rangefinders, whose readings are metres or counts. What is in the way of a ray is in
// physical/sensors/range_sensor.h.
#pragma once

#include <array>
#include <cstdint>

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct RangeDevice {
  std::string name;  ///< '1' … '12', 'left', …
  std::size_t body = 0;
  Vec3 p_B, direction;
  double range = 0.2;
  /// Counts = a · v^b or c0 + c1 v + c2 v², v = exp(-distance); metres: the distance itself.
  enum class Calibration : std::uint8_t { metres, power, quadratic };
  Calibration calibration = Calibration::metres;
  std::array<double, 3> coefficients{};
};

/// What it reads when nothing is in reach: its range, or no counts.
double without_hit(const RangeDevice& device);

struct RangeReading {
  double proximity = 0;  ///< in the unit of its calibration: counts, or m
  double illuminance = 0;

  static void fields(auto&& each, auto& reading) {
    each("proximity", reading.proximity, ""), each("illuminance", reading.illuminance, "");
  }
};

struct RangefinderKind {
  using Device = RangeDevice;
  using Reading = RangeReading;
  struct Devices {
    std::vector<RangeDevice> rangefinders;
  };
  struct Readings {
    std::vector<RangeReading> rangefinders;
  };
  static constexpr const char* key = "rangefinders";
  static constexpr const char* noun = "rangefinder";
  static constexpr const char* doc = "";
  static constexpr const char* argos_sensor = "builderbot_rangefinders";
  static auto& devices(auto& robot) { return robot.rangefinders; }
  static auto& readings(auto& readings) { return readings.rangefinders; }
  static const Form& form();
  static RangeDevice read(const FormView& view, DeviceParts& parts);
  static RangeReading before(const RangeDevice& device) { return {without_hit(device), 0}; }
  static std::string description(const RobotModel& robot);
};

}  // namespace stig::robots
