// SPDX-License-Identifier: MIT
// What a robot's program shows of its mind, as text of a trace's channel "show":
//
//     {"numbers": {"distance": 0.2}, "texts": {"state": "search"},
//      "arrows": [[[0, 0, 0], [0.1, 0, 0], "#ff9000"]]}
//
// Lists that are empty are left out. Arrows go from, to, in the frame of the robot's root body.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physical/render/scene_picture.h"
#include "physical/render/uses.h"
#include "robots/robot_io.h"

namespace stig::physics {

std::string show_json(const UserData& shown, const Pose& X_BR);
/// Arrows of such a text, as lines in the world, for pictures; none when it is something else.
std::vector<PictureLine> show_lines(std::string_view json, const Pose& X_WB);

}  // namespace stig::physics
