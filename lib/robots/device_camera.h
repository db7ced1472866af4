// SPDX-License-Identifier: MIT
// Cameras that tell tags and LEDs. What they see of a world is in physical/sensors/camera_sensor.h.
#pragma once

#include <array>

#include "robots/device.h"
#include "robots/uses.h"
#include "sensing/camera.h"

namespace stig::robots {

struct CameraDevice {
  std::string name;
  std::size_t body = 0;
  Pose X_BC;  ///< optical frame: z ahead, x right, y down
  CameraIntrinsics intrinsics;
  double near = 0.05, far = 0.5;
};

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

struct CameraKind {
  using Device = CameraDevice;
  using Reading = CameraReading;
  struct Devices {
    std::vector<CameraDevice> cameras;
  };
  struct Readings {
    std::vector<CameraReading> cameras;
  };
  static constexpr const char* key = "cameras";
  static constexpr const char* noun = "camera";
  static constexpr const char* doc = "";
  static constexpr const char* argos_sensor = "builderbot_camera_system";
  static auto& devices(auto& robot) { return robot.cameras; }
  static auto& readings(auto& readings) { return readings.cameras; }
  static const Form& form();
  static CameraDevice read(const FormView& view, DeviceParts& parts);
  /// The line of robot.description about the robot's first camera.
  static std::string description(const RobotModel& robot);
};

}  // namespace stig::robots
