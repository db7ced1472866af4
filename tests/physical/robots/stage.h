// SPDX-License-Identifier: MIT
// A robot that tests command by hand.
#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "physical/robots/robot_body.h"
#include "robots/robot_reader.h"
#include "support/uses.h"

namespace stig {

inline RobotModel robot_of(const std::string& name) {
  Diagnostics diagnostics;
  const auto robot = read_robot_file(STIG_SOURCE_DIR "/robots/" + name, diagnostics);
  REQUIRE_MESSAGE(robot, to_text(diagnostics));
  return *robot;
}

/// A robot alone on the floor, and what has been commanded.
struct Stage {
  RobotModel robot;
  WorldConfig config;
  Materials materials;
  RobotBody body;
  RobotDevices devices;
  std::optional<World> world;

  explicit Stage(const std::string& name, const Pose& X_WR = {}) : robot(robot_of(name)) {
    config.frictions = {{kBlockMaterial, kBlockMaterial, 0.2},
                        {kBlockMaterial, kFloorMaterial, 0.4}};
    body = add_robot(config, robot, X_WR, materials);
  }
  void begin() {
    for (const std::string& problem : problems_of(config)) CAPTURE(problem);
    REQUIRE(problems_of(config).empty());
    world.emplace(config);
  }
  void tell(const RobotCommands& commands) { command(devices, robot, commands); }
  void wheels(double left, double right) {
    RobotCommands commands;
    commands.wheels = {left, right};
    tell(commands);
  }
  void lift_to(double height) {
    RobotCommands commands;
    commands.lift = {LiftCommand::Kind::position, height};
    tell(commands);
  }
  void discharge(Discharge mode) {
    RobotCommands commands;
    commands.discharge = mode;
    tell(commands);
  }
  void run(double seconds) {
    const double end = world->time() + seconds - 1e-9;
    while (world->time() < end) {
      act(*world, robot, body, devices, config.step);
      REQUIRE(world->step().ok);
    }
  }
  Pose place() const { return pose_of(*world, robot, body); }
  RobotReadings readings() const {
    RobotReadings out;
    read(*world, robot, body, devices, out);
    return out;
  }
};

}  // namespace stig
