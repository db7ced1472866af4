// SPDX-License-Identifier: MIT
// Compasses: the heading of a body.
//
// A heading is the angle from the world's x axis to the projection of the body's x axis onto the
// floor, counter-clockwise as seen from above. It has no meaning while that axis stands upright.
#pragma once

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct CompassDevice {
  std::string name;
  std::size_t body = 0;
  double noise = 0;  ///< rad, standard deviation of the heading

  static void fields(auto&& each, auto& device) { each("noise", device.noise, "rad"); }
};

struct CompassReading {
  double heading = 0;  ///< rad, from -π to π

  static void fields(auto&& each, auto& reading) { each("heading", reading.heading, "rad"); }
};

struct CompassKind {
  using Device = CompassDevice;
  using Reading = CompassReading;
  struct Devices {
    std::vector<CompassDevice> compasses;
  };
  struct Readings {
    std::vector<CompassReading> compasses;
  };
  static constexpr const char* key = "compasses";
  static constexpr const char* noun = "compass";
  static constexpr const char* doc = "Headings of bodies.";
  static auto& devices(auto& robot) { return robot.compasses; }
  static auto& readings(auto& readings) { return readings.compasses; }
  static const Form& form();
  static CompassDevice read(const FormView& view, DeviceParts& parts);
  /// With Gaussian noise, of which `random` is a stream for this reading alone.
  static CompassReading sense(const CompassDevice& device, const BodyMotion& body, Random& random);
};

}  // namespace stig::robots
