// SPDX-License-Identifier: MIT
// What programs are told of the robot that runs them, as `robot.description`: the figures of its
// file that no sensor tells. docs/controllers.md lists them; each kind of device (device.h) says
// its own.
//
// It is a text of Lua, since it goes into programs for hosts that know nothing of robots' files
// too; so the figures are the same numbers everywhere, rounded to six digits.
#pragma once

#include <string>
#include <string_view>

#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

/// A table of Lua, on several lines. What the robot does not have is not in it.
std::string robot_description(const RobotModel& robot);

/// A text in quotes of Lua.
std::string lua_quoted(std::string_view text);
/// x, y and z as entries of a table.
std::string described_place(const Vec3& place);

}  // namespace stig::robots
