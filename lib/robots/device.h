// SPDX-License-Identifier: MIT
// What a kind of device is: all that a robot can have besides bodies and joints, sensors as well
// as motors.
//
// A kind says once what everybody who goes through the kinds needs to know of it; device_kinds.h
// lists them, and device_compass.h is the shortest whole example. Its members:
//
//     Device                 what a robot's file says of one; a kind of which a robot has one
//                            at most has a Model instead
//     Devices                the members of RobotModel that hold them, and
//     devices(robot)         the way to these: a list, or an optional
//     key, noun, doc         of the robot's file; what one is called; a line for editors
//     form(), read(…)        the keys of an entry, and the entry as a Device
//
// and where they apply:
//
//     Reading                what one tells its program in a control step, and
//     Readings, readings(…)  the members of RobotReadings that hold these
//     sense(…)               the reading of a sensor that perceives nothing but how its body is
//                            placed and moves
//     before(device)         what is read before anything has been measured
//     program_key            its table in a program's `robot`, where that is not `key`
//     description(robot)     its part of robot.description (robot_description.h)
//     argos_sensor, argos_actuator   what the BuilderBot of ARGoS calls its interfaces
//
// A Device or Reading that is a few figures lists them, each with its name and unit:
//
//     static void fields(auto&& each, auto& device) { each("noise", device.noise, "rad"); }
//
// From those follow the bytes of readings, the table in Lua, robot.description and what
// `stigc describe` tells. Kinds whose members say more write these out themselves.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/vec.h"
#include "robots/uses.h"

namespace stig {
class FormView;
class Random;
struct Form;
}  // namespace stig

namespace stig::robots {

class DeviceParts;  // device_parts.h
struct RobotModel;

/// One axis of one joint, by their places in RobotModel::joints and JointModel::axes.
struct AxisRef {
  std::size_t joint = 0, axis = 0;
};

/// How a body is placed and moves, in the world's frame: all that a sensor in it can perceive
/// without looking out.
struct BodyMotion {
  Pose X_WB;
  Vec3 velocity, spin;  ///< m/s, of its middle; rad/s
};

}  // namespace stig::robots
