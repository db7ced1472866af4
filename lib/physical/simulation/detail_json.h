// SPDX-License-Identifier: MIT
// What a detailed trace has besides poses, for those who look at a run: as text of two channels.
//
// "senses", of a robot's root body, at each of its control steps:
//
//     {"ranges": [0.1, …], "wheels": [0.05, 0.05], "lift": 0.08, "charge": 24.6,
//      "cameras": [{"tags": [[id, [u, v, …], [x, y, z]], …], "leds": [[u, v, Y, U, V], …]}],
//      "heard": [[radio, "text"], …], "sent": [[radio, "text"], …]}
//
// Lists are in the order of the devices in the robot's file, units those of robot_io.h; tags have
// their four corners in the picture and their place in the camera's frame. What a robot does not
// have, and empty lists, are left out.
//
// "magnets", of a block: the directions of its magnets in its frame, in hundredths, [x, y, z, x,
// …].
#pragma once

#include <string>

#include "physical/dynamics/world.h"
#include "physical/simulation/uses.h"
#include "robots/robot_io.h"
#include "robots/robot_model.h"

namespace stig::physics {

std::string senses_json(const RobotModel& model, const RobotReadings& readings,
                        const RobotCommands& commands);
std::string magnets_json(const World& world, BodyId body, std::size_t magnets);

}  // namespace stig::physics
