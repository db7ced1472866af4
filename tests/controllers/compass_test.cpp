// SPDX-License-Identifier: MIT
// Compasses: their entry in a robot's file, their reading, and what programs find of them.
#include "robots/device_compass.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "controllers/lua_fixture.h"
#include "robots/robot_reader.h"
#include "support/uses.h"

namespace stig {
namespace {

constexpr double kPi = std::numbers::pi;

constexpr const char* kPost = R"(stigc_robot: 1
name: post
bodies:
  - {name: post, box: [0.1, 0.1, 0.1], mass: 1, base: [0, 0, 0]}
compasses:
  - {name: exact, body: post}
  - {name: shaky, body: post, noise: 0.05}
)";

RobotModel post() {
  Diagnostics diagnostics;
  auto robot = read_robot(std::make_shared<SourceFile>("post.yaml", kPost), diagnostics);
  REQUIRE_MESSAGE(robot, to_text(diagnostics));
  return *robot;
}

std::string said_of_compass(const std::string& entry) {
  const std::string head(kPost, std::string_view(kPost).find("  - {name: exact"));
  Diagnostics diagnostics;
  read_robot(std::make_shared<SourceFile>("post.yaml", head + "  - " + entry + "\n"), diagnostics);
  return to_text(diagnostics);
}

double heading_of(const Quat& q, double noise = 0, std::uint64_t tick = 0) {
  Random random(1, 0, Purpose::sense, 0, tick);
  return CompassKind::sense({"c", 0, noise}, {{{}, q}, {}, {}}, random).heading;
}

}  // namespace

TEST_CASE("a robot's file has compasses") {
  const RobotModel robot = post();
  REQUIRE(robot.compasses.size() == 2);
  CHECK(robot.compasses[0].name == "exact");
  CHECK(robot.compasses[0].noise == 0);
  CHECK(robot.compasses[1].body == 0);
  CHECK(robot.compasses[1].noise == 0.05);
}

TEST_CASE("what is wrong with a compass is said at its entry") {
  CHECK(said_of_compass("{name: c, body: pots}").find("P601") != std::string::npos);
  CHECK(said_of_compass("{name: c}").find("'body'") != std::string::npos);
  CHECK(said_of_compass("{name: c, body: post, noise: -1}").find("R105") != std::string::npos);
  CHECK(said_of_compass("{name: c, body: post, noise: 4}").find("R105") != std::string::npos);
  CHECK(said_of_compass("{name: c, body: post}\n  - {name: c, body: post}").find("P603") !=
        std::string::npos);
}

TEST_CASE("a heading is the turn about the vertical, whatever the tilt ahead") {
  CHECK(heading_of({}) == 0);
  CHECK(heading_of(rotation({0, 0, kPi / 2})) == doctest::Approx(kPi / 2));
  CHECK(rc::check("the heading of a turn, a pitch and a roll is the turn", [] {
    const auto draw = [](double most) { return most * *rc::gen::inRange(-1000, 1001) / 1000.0; };
    const double turn = draw(3.1), pitch = draw(1.5), roll = draw(3.1);
    const Quat q = rotation({0, 0, turn}) * rotation({0, pitch, 0}) * rotation({roll, 0, 0});
    RC_ASSERT(std::abs(heading_of(q) - turn) < 1e-9);
  }));
}

TEST_CASE("noise has its standard deviation, and readings stay from -pi to pi") {
  constexpr int kCount = 20'000;
  constexpr double kNoise = 0.05;
  double sum = 0, squares = 0;
  for (std::uint64_t tick = 0; tick < kCount; ++tick) {
    // Half of these go past pi.
    const double heading = heading_of(rotation({0, 0, kPi}), kNoise, tick);
    REQUIRE(std::abs(heading) <= kPi);
    const double error = std::remainder(heading - kPi, 2 * kPi);
    sum += error;
    squares += error * error;
  }
  // Five standard errors: of the mean noise / sqrt(count), of the deviation noise / sqrt(2 count).
  CHECK(std::abs(sum / kCount) < 5 * kNoise / std::sqrt(kCount));
  CHECK(std::sqrt(squares / kCount) ==
        doctest::Approx(kNoise).epsilon(5 / std::sqrt(2.0 * kCount)));
}

TEST_CASE("programs find headings by the compasses' names, and their noise in the description") {
  Running running(R"(
    local noise = robot.description.compasses
    print(robot.compasses.exact.heading, noise.exact.noise, noise.shaky.noise)
    function step() print(robot.compasses.exact.heading, robot.compasses.shaky.heading) end)",
                  settings_of(), post());
  CHECK(joined(running.commands.log) == "0.0\t0\t0.05");
  RobotReadings readings;
  readings.compasses = {{0.5}, {-1.25}};
  CHECK(running.step(readings).ok);
  CHECK(joined(running.commands.log) == "0.5\t-1.25");
  Running without("print(robot.compasses, robot.description.compasses)");
  CHECK(joined(without.commands.log) == "nil\tnil");
}

}  // namespace stig
