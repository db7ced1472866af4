// SPDX-License-Identifier: MIT
// A robot's own lights, of any colour.
#pragma once

#include "robots/device.h"
#include "robots/uses.h"

namespace stig::robots {

struct LedDevice {
  std::string name;
  std::size_t body = 0;
  Vec3 p_B;
};

struct LedKind {
  using Device = LedDevice;
  struct Devices {
    std::vector<LedDevice> leds;
  };
  struct Readings {};
  static constexpr const char* key = "leds";
  static constexpr const char* noun = "LED";
  static constexpr const char* doc = "Lights of any colour, seen from everywhere.";
  static auto& devices(auto& robot) { return robot.leds; }
  static const Form& form();
  static LedDevice read(const FormView& view, DeviceParts& parts);
};

}  // namespace stig::robots
