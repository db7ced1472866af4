// SPDX-License-Identifier: MIT
// The shipped robots in the world: they weigh what they should, drive, turn, rest, lift, and
// carry a block.

#include <cmath>
#include <numbers>

#include "physical/robots/stage.h"
#include "support/uses.h"

using namespace stig;

namespace {

double tilt(const Pose& pose) { return std::acos(std::min(1.0, matrix(pose.q).z.z)); }

}  // namespace

TEST_CASE("the robot of 2017 in the world: fifteen bodies of its mass, on its wheels") {
  Stage stage("bebot.yaml", {{1, 2, 0}, rotation({0, 0, 0.7})});
  REQUIRE(stage.config.bodies.size() == 15);
  double mass = 0;
  for (const BodyDef& body : stage.config.bodies) mass += body.mass;
  CHECK(mass == doctest::Approx(2.295).epsilon(1e-12));
  CHECK(stage.body.poles.size() == 4);
  stage.begin();
  CHECK(length(stage.place().p - Vec3{1, 2, 0}) < 1e-12);
  // It neither creeps nor sinks.
  stage.run(5);
  CHECK(length(stage.place().p - Vec3{1, 2, 0}) < 1e-4);
}

TEST_CASE("robots drive a metre straight at cruising speed, without slip or tipping") {
  for (const char* name : {"bebot.yaml", "builderbot.yaml"}) {
    CAPTURE(name);
    Stage stage(name);
    stage.begin();
    stage.wheels(0.165, 0.165);
    stage.run(0.5);
    const Vec3 from = stage.place().p;
    stage.run(1 / 0.165);
    const Pose end = stage.place();
    CHECK(end.p.x - from.x == doctest::Approx(1).epsilon(0.02));
    CHECK(std::abs(end.p.y) < 0.01);
    CHECK(tilt(end) < 0.01);
    CHECK(stage.readings().left_encoder == doctest::Approx(0.165).epsilon(0.01));
    stage.wheels(0, 0);
    for (int i = 0; i < 50; ++i) {
      stage.run(0.02);
      CHECK(tilt(stage.place()) < 0.03);
    }
    CHECK(std::abs(stage.readings().left_encoder) < 0.001);
  }
}

TEST_CASE("robots turn round on the spot as kinematics says") {
  for (const char* name : {"bebot.yaml", "builderbot.yaml"}) {
    CAPTURE(name);
    Stage stage(name);
    stage.begin();
    const double speed = 0.082;
    stage.wheels(-speed, speed);
    stage.run(0.5);
    double turned = 0;
    const auto heading = [&] {
      const Vec3 x = matrix(stage.place().q).x;
      return std::atan2(x.y, x.x);
    };
    double last = heading();
    const double begin = stage.world->time();
    while (turned < 2 * std::numbers::pi) {
      REQUIRE(stage.world->time() < 30);
      stage.run(stage.config.step);
      const double now = heading();
      turned += std::remainder(now - last, 2 * std::numbers::pi);
      last = now;
    }
    const double theory = std::numbers::pi * stage.robot.drive->track / speed;
    CHECK(stage.world->time() - begin == doctest::Approx(theory).epsilon(0.02));
  }
}

TEST_CASE("the lift goes up, down, and knows its switches") {
  Stage stage("bebot.yaml");
  stage.begin();
  stage.lift_to(0.135);
  stage.run(0.1);
  CHECK(stage.readings().lift.active);
  stage.run(2);
  CHECK(stage.readings().lift.position == doctest::Approx(0.135).epsilon(0.01));
  CHECK_FALSE(stage.readings().lift.active);
  RobotCommands calibrate;
  calibrate.lift = {LiftCommand::Kind::calibrate, 0};
  stage.tell(calibrate);
  stage.run(3);
  CHECK(stage.readings().lift.at_bottom);
  CHECK(tilt(stage.place()) < 0.01);
}

TEST_CASE("magnets pick a block up and hold it through a stop from cruising speed") {
  Stage stage("bebot.yaml");
  Diagnostics diagnostics;
  const auto model = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  REQUIRE(model);
  const auto block = static_cast<std::uint32_t>(stage.config.bodies.size());
  stage.config.bodies.push_back(block_body(*model, {{0.093755, 0.001, 0.0275 - 1e-5}, {}}));
  stage.begin();
  stage.run(6);  // charges
  CHECK(stage.readings().magnet_voltage == 250);
  stage.discharge(Discharge::constructive);
  stage.run(1);
  stage.discharge(Discharge::disable);
  stage.lift_to(0.06);
  stage.run(2);
  const auto height = [&] { return stage.world->state(BodyId{block}).X_WB.p.z; };
  const auto in_robot = [&] {
    return (inverse(stage.place()) * stage.world->state(BodyId{block}).X_WB).p;
  };
  CHECK(height() > 0.0275 + 0.05);
  const Vec3 held = in_robot();
  stage.wheels(0.165, 0.165);
  stage.run(1.5);
  stage.wheels(0, 0);
  stage.run(1.5);
  CHECK(length(in_robot() - held) < 0.003);
  stage.wheels(-0.082, 0.082);
  stage.run(2);
  stage.wheels(0, 0);
  stage.run(1);
  CHECK(height() > 0.0275 + 0.05);
}

TEST_CASE("a cart's arm and fingers follow their commands") {
  Stage stage("gripper_cart.yaml");
  stage.begin();
  RobotCommands commands;
  commands.joints = {0.5, -0.2, std::nullopt, 1.0};
  stage.tell(commands);
  stage.run(3);
  const RobotReadings readings = stage.readings();
  REQUIRE(readings.joints.size() == 4);
  CHECK(readings.joints[0].position == doctest::Approx(0.5).epsilon(0.02));
  CHECK(readings.joints[1].position == doctest::Approx(-0.2).epsilon(0.02));
  // Pressed against its stop.
  CHECK(readings.joints[3].position == doctest::Approx(0.03).epsilon(0.02));
}
