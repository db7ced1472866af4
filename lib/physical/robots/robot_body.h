// SPDX-License-Identifier: MIT
// A robot of a file as bodies, joints and magnets of a world, and the way from its devices'
// states to motors and back.
//
//     WorldConfig config;
//     Materials materials;
//     const RobotBody body = add_robot(config, robot, X_WR, materials);
//     World world(config);
//     RobotDevices devices;
//     command(devices, robot, commands);            // at a control tick
//     act(world, robot, body, devices, config.step);  // before every step of the world
//     world.step();
//
// All bodies of the file are bodies of the world, fixed ones too: joints without axes, whose
// masses and inertias the world adds up exactly. All have their true shapes, but wheels that the
// file has as balls.
#pragma once

#include <string>
#include <vector>

#include "physical/dynamics/world.h"
#include "physical/robots/uses.h"
#include "robots/robot_devices.h"
#include "robots/robot_model.h"

namespace stig::physics {

/// Names of kinds of surface; their places are the numbers of WorldConfig::frictions.
struct Materials {
  std::vector<std::string> names{"block", "floor"};
  /// The number of a name; one seen for the first time gets the next.
  Material number(const std::string& name);
};

/// Numbers of a robot's parts in its world, by their places in the model.
struct RobotBody {
  std::vector<BodyId> bodies;
  std::vector<JointId> joints;
  std::vector<std::size_t> poles;  ///< of each pole: which of its body's magnets it is
};

/// Adds a robot that stands at X_WR, every joint at zero; all its parts follow those that the
/// configuration has. Wheels grip the floor with 0.9 and casters slide with 0.02 unless the
/// configuration says otherwise.
RobotBody add_robot(WorldConfig& config, const RobotModel& robot, const Pose& X_WR,
                    Materials& materials);

/// Adds bodies in their places in the world: fixed to it, or as one body, fixed to the first.
void add_fixed_together(WorldConfig& config, const std::vector<BodyModel>& bodies, bool to_world,
                        Materials& materials);

/// The states of a robot's devices.
struct RobotDevices {
  DriveState drive;
  LiftState lift;
  MagnetState magnets;
  std::vector<double> joints;  ///< targets of the file's actuators, as last commanded
};

/// What a control step's commands change.
void command(RobotDevices& devices, const RobotModel& robot, const RobotCommands& commands);
/// Stops wheels and lift and switches the magnets off: of a robot whose program has failed.
void make_safe(RobotDevices& devices);
/// Steps the devices by dt seconds and sets motors and currents.
void act(World& world, const RobotModel& robot, const RobotBody& body, RobotDevices& devices,
         double dt);
/// Fills in what comes from joints and devices: encoders, lift, voltage, actuators.
void read(const World& world, const RobotModel& robot, const RobotBody& body,
          const RobotDevices& devices, RobotReadings& readings);

/// Where a body of the model is; its sensors' frames follow from it.
Pose pose_of(const World& world, const RobotBody& body, std::size_t place);
/// Where the robot is: its root's pose, taken back to the frame of its file.
Pose pose_of(const World& world, const RobotModel& robot, const RobotBody& body);

}  // namespace stig::physics
