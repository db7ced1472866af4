// SPDX-License-Identifier: MIT
// About which point a robot turns; tests/behaviour/drive_test.cpp holds it to physics.
#include "robots/robot_pivot.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

/// A plate on balls of one radius: each axle is a wheel left and right, then there are casters.
RobotModel plate_on(std::initializer_list<double> axles, std::initializer_list<double> casters,
                    double centre) {
  RobotModel robot;
  const auto add = [&](double x, double y, double z, double size, double mass) {
    BodyModel body;
    body.size = {size, size, size};
    body.mass = mass;
    body.X_RB.p = {x, y, z};
    robot.bodies.push_back(body);
  };
  add(centre, 0, 0.05, 0.01, 1);
  robot.drive.emplace();
  for (const double x : axles) {
    for (const double y : {0.05, -0.05}) {
      add(x, y, 0.02, 0.04, 1e-9);
      (y > 0 ? robot.drive->left : robot.drive->right).push_back({robot.joints.size(), 0});
      JointModel joint;
      joint.child = robot.bodies.size() - 1;
      joint.axes.emplace_back();
      robot.joints.push_back(joint);
    }
  }
  for (const double x : casters) add(x, 0, 0.02, 0.04, 1e-9);
  return robot;
}

TEST_CASE("shipped robots turn about the axle that bears most") {
  CHECK(pivot_of(shipped_robot("bebot.yaml")) == doctest::Approx(0.03175));
  CHECK(pivot_of(shipped_robot("builderbot.yaml")) == doctest::Approx(0.030));
  CHECK(pivot_of(shipped_robot("gripper_cart.yaml")) == doctest::Approx(-0.05));
}

TEST_CASE(
    "of two axles it is the one nearer to the centre of mass, between equal ones the middle") {
  CHECK(pivot_of(plate_on({-0.03, 0.05}, {}, 0.02)) == doctest::Approx(0.05));
  CHECK(pivot_of(plate_on({0.05, -0.03}, {}, 0.0)) == doctest::Approx(-0.03));
  CHECK(pivot_of(plate_on({-0.03, 0.05}, {}, 0.01)) == doctest::Approx(0.01));
}

TEST_CASE("casters bear load, and scrub nothing") {
  CHECK(pivot_of(plate_on({0.04}, {-0.05}, -0.04)) == doctest::Approx(0.04));
  // Three rows of supports that give way alike: the caster in front takes the load off the front
  // axle, and the rear one bears more.
  CHECK(pivot_of(plate_on({-0.05, 0}, {}, -0.02)) == doctest::Approx(0));
  CHECK(pivot_of(plate_on({-0.05, 0}, {0.05}, -0.02)) == doctest::Approx(-0.05));
}

TEST_CASE("three axles: the middle one, until an outer one bears half of all") {
  CHECK(pivot_of(plate_on({-0.05, 0, 0.05}, {}, 0)) == doctest::Approx(0));
  CHECK(pivot_of(plate_on({-0.05, 0, 0.05}, {}, 0.01)) == doctest::Approx(0));
  CHECK(pivot_of(plate_on({-0.05, 0, 0.05}, {}, 0.03)) == doctest::Approx(0.05));
}

}  // namespace
}  // namespace stig
