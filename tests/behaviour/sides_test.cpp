// SPDX-License-Identifier: MIT
// A robot that goes to another side of the structure, where nobody works.
#include <fmt/format.h>

#include <cmath>

#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

namespace {

constexpr double kMost = 120;  ///< s

/// The robot that changes sides begins 0.3 m from a brick, on side +x, and faces it.
std::string scene(const std::string& params, const std::string& others = "") {
  return "stigc_scene: 1\nblocks: [{at: [0, 0, 0.0275], color: Q3, fixed: true}]\nrobots:\n"
         "  - {file: bebot.yaml, at: [0.3, 0], heading: 180, program: sides_probe.lua, params: "
         "{side: "
         "\"+x\"" +
         params + "}}\n" + others;
}

std::string standing(double x, double y, double heading) {
  return fmt::format(
      "  - {{file: bebot.yaml, at: [{}, {}], heading: {}, program: drive_probe.lua}}\n", x, y,
      heading);
}

double away(const Pose& pose, double x, double y) { return std::hypot(pose.p.x - x, pose.p.y - y); }

}  // namespace

TEST_CASE("a side where nobody is is the robot's next, and it expects a cache there") {
  Trial trial(scene(""));
  REQUIRE(trial.until(kMost, "changed"));
  INFO(trial.log());
  CHECK(trial.said("changed true, side +y, cache at 0.30 -0.50"));
  CHECK(away(trial.robot(), 0, 0.29) < 0.04);
}

TEST_CASE("where another robot stands it turns back, and touches nobody") {
  struct Place {
    double x, y, heading;
  };
  for (const Place at : {Place{0, 0.28, -90}, Place{0, 0.36, 90}, Place{0.05, 0.20, -90}}) {
    CAPTURE(at.x);
    CAPTURE(at.y);
    Trial trial(scene("", standing(at.x, at.y, at.heading)));
    const Pose before = trial.robot(1);
    REQUIRE(trial.until(kMost, "changed"));
    INFO(trial.log());
    CHECK(trial.said("changed false, side +x, cache at -0.20 0.00"));
    CHECK(away(trial.robot(), 0.29, 0) < 0.04);
    CHECK(away(trial.robot(1), before.p.x, before.p.y) < 0.001);
  }
}

TEST_CASE("a robot that is bound to sides goes there without a look") {
  Trial trial(scene(", sides: \"+x +y\"", standing(0.55, 0, 0)));
  REQUIRE(trial.until(30, "changed"));
  INFO(trial.log());
  CHECK(trial.said("changed true, side +y"));
}
