// SPDX-License-Identifier: MIT
// What programs are told of the robot that runs them.
#include "robots/robot_description.h"

#include <doctest/doctest.h>

#include "controllers/lua_fixture.h"
#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

/// What a program on this robot says of its description.
std::string told(const RobotModel& robot, const std::string& expression) {
  Running running("local d = robot.description print(" + expression + ")", settings_of(), robot);
  return running.status.ok ? joined(running.commands.log) : running.status.error;
}

TEST_CASE("the description is what the robot's file says") {
  const RobotModel robot = shipped_robot("bebot.yaml");
  CHECK(told(robot, "d.name") == "bebot");
  CHECK(told(robot, "d.drive.track, d.drive.speed, d.drive.acceleration") == "0.07106\t0.33\t1");
  CHECK(told(robot, "d.lift.top, d.lift.tolerance") == "0.137\t0.001");
  CHECK(told(robot, "d.drive.pivot") == "0.03175");
  CHECK(told(robot, "d.effector.front, d.effector.half_width") == "0.129755\t0.033");
  CHECK(told(robot, "d.body.front, d.body.back, d.body.half_width") == "0.0475\t0.073845\t0.04375");
  CHECK(told(robot, "d.magnets.ahead, d.magnets.neutral") == "0.093755\t165");
  CHECK(told(robot, "d.camera.anchor.x, d.camera.anchor.z, d.camera.focal") ==
        "0.055755\t0.079\t883.961");
  CHECK(told(robot, "d.rangefinders.left.x, d.rangefinders.left.calibration") == "0.057755\tpower");
  CHECK(told(robot, "d.rangefinders['1'].range, table.unpack(d.rangefinders['1'].coefficients)") ==
        "0.2\t1253.394\t-5493.967\t7164.404");
}

TEST_CASE("what is not there is not told") {
  CHECK(told(shipped_robot("builderbot.yaml"),
             "d.rangefinders.front.calibration, d.magnets.neutral") == "metres\t15.114");
  const RobotModel cart = shipped_robot("gripper_cart.yaml");
  CHECK(told(cart, "d.lift, d.magnets, d.effector, d.body") == "nil\tnil\tnil\tnil");
  CHECK(told({}, "d.drive, d.camera, next(d.rangefinders)") == "nil\tnil\tnil");
}

TEST_CASE("names from a robot's file stay texts") {
  RobotModel robot;
  robot.name = "it's\\\n']] error()";
  robot.bodies.resize(1);
  robot.rangefinders = {{"'] = error() --", 0, {}, {1, 0, 0}, 0.2, {}, {}}};
  CHECK(told(robot, "d.name") == robot.name);
  CHECK(told(robot, "next(d.rangefinders)").starts_with("'] = error() --"));
}

}  // namespace
}  // namespace stig
