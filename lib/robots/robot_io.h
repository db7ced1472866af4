// SPDX-License-Identifier: MIT
// What a controller reads and commands in one control step. This contract is all that passes
// between a controller and its robot: no pose, no clock but its own, nothing of the world that
// a sensor did not see.
//
// Lists are in the order of the devices in the robot's file (RobotModel); names are there.
// Lengths in m, angles in rad, times in s, pixels from the image's upper left corner.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "sensing/camera.h"

namespace stig {

/// A tag as the camera's algorithm reports it: what pixels say, errors included.
struct TagReading {
  int id = 0;
  Vec3 p_CT;  ///< of its centre, in the camera's frame (z ahead, x right, y down)
  Quat q_CT;  ///< of its axes: z out of the tag's face towards the viewer
  ImagePoint centre;
  std::array<ImagePoint, 4> corners;  ///< counter-clockwise as seen, from the tag's lower left
};

/// A lit LED where it appears, and its colour in the planes of the image.
struct LedReading {
  ImagePoint centre;
  double y = 0, u = 0, v = 0;  ///< 0 to 255
};

struct CameraReading {
  bool enabled = false;
  double timestamp = 0;
  std::vector<TagReading> tags;
  std::vector<LedReading> leds;  ///< in reach of detect_led, not listed to Lua
  Pose X_RC;                     ///< where the camera stands now, in the robot's frame
};

struct RangeReading {
  double proximity = 0;  ///< in the unit of its calibration: counts, or m
  double illuminance = 0;
};

struct LiftReading {
  bool active = false;  ///< moving towards a set position
  bool calibrating = false;
  double position = 0;
  bool at_top = false, at_bottom = false;  ///< limit switches
};

struct JointReading {
  double position = 0, velocity = 0;  ///< rad or m, and a second
};

/// Bytes, any.
using Message = std::string;

struct RobotReadings {
  std::uint64_t tick = 0;
  double time = 0;          ///< since this controller's init
  double temperature = 25;  ///< °C, of the system
  std::vector<CameraReading> cameras;
  std::vector<RangeReading> rangefinders;
  std::vector<std::vector<Message>> radios;    ///< received since the last step
  double left_encoder = 0, right_encoder = 0;  ///< m/s, of the wheels' rims
  LiftReading lift;
  double magnet_voltage = 0;         ///< of the electromagnets' charge, in the profile's unit
  std::vector<JointReading> joints;  ///< of the file's free actuators
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

}  // namespace stig
