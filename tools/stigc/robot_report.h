// SPDX-License-Identifier: MIT
// A robot as text and as JSON.
#pragma once

#include <string>

#include "robots/robot_model.h"
#include "uses.h"

namespace stig::cli {

std::string to_text(const RobotModel& robot, bool color);
std::string to_json(const RobotModel& robot);

}  // namespace stig::cli
