// SPDX-License-Identifier: MIT
// What a controller reads and commands in one control step. This contract is all that passes
// between a controller and its robot: no pose, no clock but its own, nothing of the world that
// a sensor did not see.
//
// Lists are in the order of the devices in the robot's file (RobotModel); names are there.
// Lengths in m, angles in rad, times in s, pixels from the image's upper left corner.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "robots/device_kinds.h"
#include "robots/uses.h"

namespace stig::robots {

/// What each kind of device tells is a member that the kind brings.
struct RobotReadings : DeviceKinds::Readings {
  std::uint64_t tick = 0;
  double time = 0;          ///< since this controller's init
  double temperature = 25;  ///< °C, of the system
};

enum class Discharge : std::uint8_t { disable, constructive, destructive };

struct LiftCommand {
  enum class Kind : std::uint8_t { none, position, stop, calibrate } kind = Kind::none;
  double position = 0;
};

/// What a robot shows of its mind: for viewers and logs, never for other robots.
struct Arrow {
  Vec3 from, to;  ///< robot's frame
  Rgb rgb;
};
struct UserData {
  std::vector<std::pair<std::string, double>> numbers;
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<Arrow> arrows;
};

struct RobotCommands {
  std::vector<std::optional<bool>> camera_enabled;
  std::optional<std::pair<double, double>> wheels;  ///< left, right: m/s of the rims, forward
  LiftCommand lift;
  std::optional<Discharge> discharge;
  std::vector<std::vector<Message>> sends;    ///< a radio each
  std::vector<std::optional<double>> joints;  ///< targets, in the actuator's mode
  std::vector<std::pair<std::size_t, Rgb>> leds;
  UserData user;
  std::vector<std::string> log;  ///< lines
};

inline constexpr std::size_t kBlockLeds = 24, kBlockRadios = 6;

/// A block's own: six radios, and LEDs that show one of the colours 0 (dark) to 4.
struct BlockReadings {
  std::uint64_t tick = 0;
  double time = 0;
  std::vector<std::vector<Message>> radios;
};
struct BlockCommands {
  std::optional<std::uint8_t> all_leds;
  std::vector<std::pair<std::size_t, std::uint8_t>> leds;
  std::vector<std::vector<Message>> sends;
  std::vector<std::string> log;
};

}  // namespace stig::robots
