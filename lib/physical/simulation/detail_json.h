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
// "contacts", of the body with the lower number, ten times a second: what its contacts push, as
//
//     [[other body, or -1 for the floor, x, y, z, Fx, Fy, Fz], …]
//
// places in millimetres, the force on the body itself in tenths of a newton.
//
// "pulls", of a body: [Fx, Fy, Fz], what magnets do to it, in tenths of a newton.
//
// A channel is known by its name: one whose text came to mean something else would get another
// name, so that no reader mistakes it. Readers pass over channels that they do not know.
//
// "magnets", of a block: the directions of its magnets in its frame, in hundredths, [x, y, z, x,
// …].
#pragma once

#include <span>
#include <string>

#include "physical/dynamics/world.h"
#include "physical/simulation/uses.h"
#include "robots/robot_io.h"
#include "robots/robot_model.h"

namespace stig::physics {

std::string senses_json(const RobotModel& model, const RobotReadings& readings,
                        const RobotCommands& commands);
std::string magnets_json(const World& world, BodyId body, std::size_t magnets);
/// Of contacts of one body, all of whose `a` it is.
std::string contacts_json(std::span<const ContactForce> contacts);
std::string force_json(const Vec3& force);

}  // namespace stig::physics
