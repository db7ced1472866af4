// SPDX-License-Identifier: MIT
// Driving as kinematics without slip says, and standing still.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

namespace {

constexpr double kCruise = 0.165;

std::string probe(const std::string& params) {
  return fmt::format(
      "stigc_scene: 1\nrobots:\n"
      "  - {{file: bebot.yaml, program: drive_probe.lua, params: {{{}, speed: {}}}}}\n",
      params, kCruise);
}

/// Where the program believes that it is, in the frame of its start: x, y, yaw.
std::array<double, 3> believed(const Trial& trial) {
  std::array<double, 3> out{};
  const std::string log = trial.log();
  const auto at = log.find("done ");
  REQUIRE(at != log.npos);
  REQUIRE(std::sscanf(log.c_str() + at, "done %lf %lf %lf", &out[0], &out[1], &out[2]) == 3);
  return out;
}

struct Drift {
  double ahead = 0, aside = 0, turned = 0;  ///< truth less belief, m, rad
};
Drift drift(const Trial& trial) {
  const auto [x, y, yaw] = believed(trial);
  const Pose X_WR = trial.robot();
  return {X_WR.p.x - x, X_WR.p.y - y, std::remainder(heading(X_WR) - yaw, 360 * kDegree)};
}

}  // namespace

TEST_CASE("a straight metre and a full turn at cruising speed are within 2 % of kinematics") {
  Trial metre(probe("ahead: 1"));
  REQUIRE(metre.until(60, "done"));
  const Drift way = drift(metre);
  MESSAGE(fmt::format("a metre: {:.2f} mm long, {:.2f} mm aside, {:.2f} degrees turned",
                      way.ahead * 1e3, way.aside * 1e3, way.turned / kDegree));
  CHECK(std::abs(metre.robot().p.x - 1) < 0.02);
  CHECK(std::abs(way.aside) < 0.02);
  Trial round(probe("turn: 360"));
  REQUIRE(round.until(60, "done"));
  const Drift turn = drift(round);
  MESSAGE(fmt::format("a full turn: {:.2f} degrees, {:.2f} mm off the spot", turn.turned / kDegree,
                      std::hypot(turn.ahead, turn.aside) * 1e3));
  CHECK(std::abs(turn.turned) < 0.02 * 360 * kDegree);
  CHECK(std::hypot(turn.ahead, turn.aside) < 0.005);
}

// Half a turn moves the middle by twice the pivot's place, some 60 mm with either robot.
TEST_CASE("in a turn on the spot the middle goes round the pivot, as odometry says") {
  for (const std::string file : {"bebot.yaml", "builderbot.yaml"}) {
    for (const double turn : {90.0, 180.0, 290.0}) {
      Trial trial(fmt::format(
          "stigc_scene: 1\nrobots:\n"
          "  - {{file: {}, program: drive_probe.lua, params: {{turn: {}, speed: 0.06}}}}\n",
          file, turn));
      REQUIRE(trial.until(60, "done"));
      const Drift off = drift(trial);
      CAPTURE(file);
      CAPTURE(turn);
      MESSAGE(fmt::format("{} turned by {}: {:.2f} mm off where it went, the middle by {:.1f} mm",
                          file, turn, std::hypot(off.ahead, off.aside) * 1e3,
                          std::hypot(trial.robot().p.x, trial.robot().p.y) * 1e3));
      CHECK(std::hypot(off.ahead, off.aside) < 0.002);
      CHECK(std::hypot(trial.robot().p.x, trial.robot().p.y) > 0.03);
    }
  }
}

// As a robot that changes sides does it, with turns either way.
TEST_CASE("turns and ways between them add up") {
  Trial trial(probe("ahead: 0.3, turn: 135, times: 5"));
  REQUIRE(trial.until(120, "done"));
  const Drift off = drift(trial);
  const double apart = std::hypot(off.ahead, off.aside);
  MESSAGE(fmt::format("1.5 m and 5 turns of 135 degrees: {:.2f} mm, {:.2f} degrees", apart * 1e3,
                      off.turned / kDegree));
  CHECK(apart < 0.02 * 1.5);
}

TEST_CASE("twice round a square: odometry drifts by little") {
  Trial trial(probe("ahead: 0.5, turn: 90, times: 8"));
  REQUIRE(trial.until(120, "done"));
  const Drift off = drift(trial);
  MESSAGE(fmt::format("4 m and 8 turns: {:.2f} mm, {:.2f} degrees",
                      std::hypot(off.ahead, off.aside) * 1e3, off.turned / kDegree));
  CHECK(std::hypot(off.ahead, off.aside) < 0.02 * 4);
}

TEST_CASE("a start and a stop at twice cruising speed do not tip the robot") {
  Trial trial(
      "stigc_scene: 1\nrobots:\n"
      "  - {file: bebot.yaml, program: drive_probe.lua, params: {ahead: 0.6, speed: 0.33}}\n");
  double most = 0;
  for (int i = 0; i < 600 && !trial.said("done"); ++i) {
    trial.until(0.02);
    most = std::max(most, tilt(trial.robot()));
  }
  REQUIRE(trial.said("done"));
  MESSAGE(fmt::format("tilted by {:.2f} degrees at most", most / kDegree));
  CHECK(most < 1 * kDegree);
  CHECK(trial.robot().p.x == doctest::Approx(0.6).epsilon(0.01));
}

TEST_CASE(
    "carrying, it starts, turns and stops without tipping, and the block stays in its place") {
  Trial trial(
      "stigc_scene: 1\nrobots:\n"
      "  - {file: bebot.yaml, program: fetch_and_stack.lua, params: {carry: 1}}\n"
      "blocks: [{name: load, at: [0.33, 0, 0.0275]}]\n");
  REQUIRE(trial.until(60, "picked up"));
  trial.until(0.5);
  const auto hangs = [&] { return (inverse(trial.robot()) * trial.block("load")).p; };
  const Vec3 before = hangs();
  double most = 0, moved = 0;
  while (!trial.said("carried") && trial.world().time() < 60) {
    trial.until(0.05);
    most = std::max(most, tilt(trial.robot()));
    moved = std::max(moved, length(hangs() - before));
  }
  REQUIRE(trial.said("carried"));
  MESSAGE(fmt::format("tilted by {:.3f} degrees, the block moved by {:.2f} mm at most",
                      most / kDegree, moved * 1e3));
  CHECK(most < 1 * kDegree);
  // Friction holds velocities: on what turns it lets a body out by r ω² dt/2 a second.
  CHECK(moved < 3e-3);
}

TEST_CASE("a robot at rest stays where it is for twenty minutes, asleep or not") {
  for (const std::string sleep : {"true", "false"}) {
    CAPTURE(sleep);
    Trial trial(
        fmt::format("stigc_scene: 1\nsleep: {{enabled: {}}}\nrobots:\n"
                    "  - {{file: bebot.yaml, at: [0.3, 0.2], heading: 30}}\n"
                    "blocks: [{{at: [0, 0, 0.0275]}}]\n",
                    sleep));
    trial.until(0.5);
    const Pose before = trial.robot();
    trial.until(20 * 60);
    const Pose after = trial.robot();
    MESSAGE(fmt::format("20 min, sleep {}: moved {:.4f} mm, turned {:.4f} degrees", sleep,
                        length(after.p - before.p) * 1e3,
                        (heading(after) - heading(before)) / kDegree));
    CHECK(length(after.p - before.p) < 0.1e-3);
    CHECK(std::abs(heading(after) - heading(before)) < 0.05 * kDegree);
  }
}
