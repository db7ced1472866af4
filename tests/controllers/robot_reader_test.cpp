// SPDX-License-Identifier: MIT
#include "robots/robot_reader.h"

#include <doctest/doctest.h>

#include <set>

#include "support/bad_files.h"
#include "support/golden.h"
#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

std::string said_of(const std::string& text) {
  Diagnostics diagnostics;
  read_robot(std::make_shared<SourceFile>("robot.yaml", text), diagnostics);
  return to_text(diagnostics);
}

const BodyModel& body(const RobotModel& robot, std::string_view name) {
  for (const BodyModel& one : robot.bodies) {
    if (one.name == name) return one;
  }
  FAIL("no such body");
  return robot.bodies[0];
}

bool near(const Vec3& a, const Vec3& b) { return length(a - b) < 1e-9; }

}  // namespace

TEST_CASE("every bad robot is told exactly what its comments say") {
  std::set<std::string> covered;
  for (const std::string& name : bad_files("tests/bad_robots")) {
    CAPTURE(name);
    const std::string text = project_file("tests/bad_robots/" + name);
    Diagnostics diagnostics;
    const bool read = read_robot(std::make_shared<SourceFile>(name, text), diagnostics).has_value();
    CHECK_MESSAGE(found(diagnostics) == expected(text), to_text(diagnostics));
    CHECK_FALSE(read);
    covered.insert(name.substr(0, 4));
  }
  for (const CodeInfo& code : all_codes()) {
    // Files of solids are another format: solid_test.cpp.
    if (code.name.substr(0, 2) == "P6" && code.name != "P618")
      CHECK_MESSAGE(covered.count(std::string(code.name)) == 1, code.name);
  }
}

TEST_CASE("the printed form of what is wrong with a robot") {
  std::string all;
  for (const char* name :
       {"P601-unknown-body", "P603-named-twice", "P606-cycle", "P609-axis-twice"}) {
    const std::string file = std::string(name) + ".yaml";
    Diagnostics diagnostics;
    read_robot(std::make_shared<SourceFile>(file, project_file("tests/bad_robots/" + file)),
               diagnostics);
    all += to_text(diagnostics) + "\n";
  }
  check_golden("tests/golden/robot-diagnostics.txt", all);
}

TEST_CASE("the robot of 2017 has fifteen bodies and its published mass") {
  const RobotModel robot = shipped_robot("bebot.yaml");
  CHECK(robot.bodies.size() == 15);
  CHECK(robot.joints.size() == 14);
  CHECK(robot.mass() == doctest::Approx(2.295).epsilon(1e-12));
  CHECK(robot.bodies[robot.root()].name == "lower chassis");
  CHECK(robot.rangefinders.size() == 16);
  CHECK(robot.control_period == 0.2);
  CHECK(near(body(robot, "lower chassis").X_RB.p, {0, 0, 0.02075}));
  // Wheels roll under their middles, whichever side they are on.
  CHECK(near(body(robot, "front left wheel").X_RB.p, {0.03175, 0.0355, 0.01575}));
  CHECK(near(body(robot, "rear right wheel").X_RB.p, {-0.03175, -0.0355, 0.01575}));
  CHECK(near(rotate(body(robot, "rear right wheel").X_RB.q, {0, 0, 1}), {0, -1, 0}));
}

TEST_CASE("devices of the robot of 2017 are where the figures have them") {
  const RobotModel robot = shipped_robot("bebot.yaml");
  const auto in_robot = [&](std::size_t on, const Vec3& p_B) {
    return robot.bodies[on].X_RB * p_B;
  };
  const CameraDevice& camera = robot.cameras.at(0);
  const Pose X_RC = robot.bodies[camera.body].X_RB * camera.X_BC;
  CHECK(near(X_RC.p, {0.112255, 0, 0.11503}));
  CHECK(near(rotate(X_RC.q, {0, 0, 1}), normalised(Vec3{1, 0, -1})));
  CHECK(near(rotate(X_RC.q, {1, 0, 0}), {0, -1, 0}));
  CHECK(near(rotate(X_RC.q, {0, 1, 0}), normalised(Vec3{-1, 0, -1})));
  CHECK(camera.intrinsics.fx == 883.961);
  CHECK(near(in_robot(robot.radios[0].body, robot.radios[0].p_B), {0.057755, 0, 0.02685}));
  REQUIRE(robot.magnets);
  for (const auto& pole : robot.magnets->poles) {
    // 17.5 mm above the magnets of a block on the floor.
    CHECK(in_robot(pole.body, pole.p_B).z == doctest::Approx(0.0275 + 0.0225 + 0.0175));
  }
  REQUIRE(robot.lift);
  CHECK(robot.joints[robot.lift->axis.joint].name == "lift");
  CHECK(robot.lift->tolerance == 0.001);
  REQUIRE(robot.drive);
  CHECK(robot.drive->left.size() == 2);
  CHECK(robot.rangefinders[0].calibration == RangeDevice::Calibration::quadratic);
  CHECK(robot.rangefinders[13].calibration == RangeDevice::Calibration::power);
}

TEST_CASE("the later robot has eight bodies and its published mass, and does not tip") {
  const RobotModel robot = shipped_robot("builderbot.yaml");
  CHECK(robot.bodies.size() == 8);
  CHECK(robot.mass() == doctest::Approx(2.239).epsilon(1e-12));
  // Between its axle and its ball, with and without a block under its magnets.
  const double axle = body(robot, "left wheel").X_RB.p.x, ball = body(robot, "rear ball").X_RB.p.x;
  const double alone = robot.centre_of_mass().x;
  const double carrying = (alone * robot.mass() + 0.110 * body(robot, "end effector").X_RB.p.x) /
                          (robot.mass() + 0.110);
  CHECK(alone > ball);
  CHECK(carrying < axle);
}

TEST_CASE("the cart uses every kind of part") {
  const RobotModel robot = shipped_robot("gripper_cart.yaml");
  std::set<ShapeType> shapes;
  for (const BodyModel& one : robot.bodies) shapes.insert(one.shape);
  CHECK(shapes.size() == 4);
  REQUIRE(robot.actuators.size() == 4);
  CHECK(robot.actuators[1].axis.axis == 1);
  const AxisModel& yaw = robot.joints[robot.actuators[0].axis.joint].axes[0];
  CHECK(yaw.upper == doctest::Approx(3.14159265358979 / 2));
  CHECK(yaw.most_speed == doctest::Approx(3.14159265358979 / 3));
  CHECK(robot.cameras[0].intrinsics.k1 == -0.2);
}

TEST_CASE("moments of solids") {
  BodyModel body;
  body.mass = 12;
  body.size = {1, 2, 3};
  CHECK(near(moments_of(body), {13, 10, 5}));
  body.shape = ShapeType::cylinder;
  body.size = {2, 2, 3};  // m (3 r² + h²) / 12, m r² / 2
  CHECK(near(moments_of(body), {12, 12, 6}));
  body.shape = ShapeType::sphere;
  body.size = {2, 2, 2};
  CHECK(near(moments_of(body), {4.8, 4.8, 4.8}));
}

TEST_CASE("the JSON Schema of robots") {
  check_golden("tests/golden/robot-schema.json", robot_schema());
}

TEST_CASE("hostile robots get an answer") {
  for (const char* text :
       {"", "- 1", "{", "\x01", "stigc_robot: 1\nname: x\nbodies: 3\njoints: [1]\n",
        "stigc_robot: 1\nname: x\nbodies: []\n",
        "stigc_robot: 1\nname: x\nbodies: [{hull: [{}]}, {}]\njoints: [{}]\n"
        "lift: {}\ndifferential_drive: {left: [x]}\ncameras: [{}]\n"
        "electromagnets: {poles: [{}]}\nactuators: [{axis: 7, joint: 1}]\n"}) {
    CAPTURE(text);
    CHECK(said_of(text).find("error[R") != std::string::npos);
  }
}

}  // namespace stig
