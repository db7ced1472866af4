// SPDX-License-Identifier: MIT
// Programs given as text, and a robot that has one of everything.
#pragma once

#include <string>
#include <vector>

#include "lua/lua_controller.h"
#include "support/uses.h"

namespace stig {

/// A camera, wheels, lift, magnets, two rangefinders, a radio, LEDs and a joint.
RobotModel whole_robot();
/// Readings that fit it, all zero.
RobotReadings empty_readings();

LuaSettings settings_of(const std::string& id = "r1");

/// A robot's program after init.
struct Running {
  explicit Running(const std::string& text, LuaSettings settings = settings_of(),
                   RobotModel model = whole_robot());
  /// A step; what it commanded is in `commands`.
  ControllerStatus step(const RobotReadings& readings = empty_readings());

  LuaController controller;
  RobotCommands commands;
  ControllerStatus status;
};

/// What a program printed while it was loaded, lines joined by '\n'; or its error.
std::string said(const std::string& text);
std::string joined(const std::vector<std::string>& lines);

}  // namespace stig
