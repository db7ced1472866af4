// SPDX-License-Identifier: MIT
// The example programs do in physics what they say, and so does a controller in C++.
#include <algorithm>
#include <cmath>

#include "behaviour/support.h"
#include "support/uses.h"

using namespace stig;
using namespace stig::behaviour;

namespace {

std::string scene_text(const std::string& name) {
  FileError error;
  const auto text = read_file(STIG_SOURCE_DIR "/scenes/" + name, kMaxSceneBytes, error);
  REQUIRE_MESSAGE(text.has_value(), error.message);
  return *text;
}

/// Drives ahead until something is nearer than 0.1 m; the same contract as a Lua program's.
class Approach final : public RobotController {
 public:
  explicit Approach(const RobotModel& model) {
    for (std::size_t i = 0; i < model.rangefinders.size(); ++i) {
      if (model.rangefinders[i].name == "2") ahead_ = i;
    }
  }
  ControllerStatus init(RobotCommands&) override { return {}; }
  ControllerStatus step(const RobotReadings& readings, RobotCommands& commands) override {
    // 1558 counts are 0.2 m, 2925 none at all
    const bool near = readings.rangefinders[ahead_].proximity > 2150;
    commands.wheels = near ? std::pair{0.0, 0.0} : std::pair{0.05, 0.05};
    return {};
  }

 private:
  std::size_t ahead_ = 0;
};

}  // namespace

TEST_CASE("the wall follower goes along a wall at its distance") {
  Trial trial(
      "stigc_scene: 1\nrobots:\n"
      "  - {file: builderbot.yaml, at: [-0.35, -0.13], program: wall_follower.lua}\n"
      "blocks:\n  - {wall: [16, 3], fixed: true}\n");
  const double face = -0.0275, half = 0.070;
  double nearest = 1, farthest = 0;
  while (trial.world().time() < 14) {
    trial.until(0.5);
    const double gap = face - trial.robot().p.y - half;
    nearest = std::min(nearest, gap);
    farthest = std::max(farthest, gap);
  }
  INFO(trial.log());
  CHECK(trial.robot().p.x > 0.05);
  CHECK(nearest > 0.005);
  CHECK(farthest < 0.05);
}

TEST_CASE("the block fetcher brings the cache's block") {
  Trial trial(scene_text("robot-fetch.yaml"));
  REQUIRE(trial.until(60, "carry"));
  trial.until(1);
  INFO(trial.log());
  // It hangs under the gripper, and is marked.
  std::size_t carried = 0;
  for (std::size_t i = 0; i < trial.blocks(); ++i) {
    const Pose at = inverse(trial.robot()) * trial.block(i);
    if (at.p.z < 0.05) continue;
    ++carried;
    CHECK(std::hypot(at.p.x - 0.094, at.p.y) < 0.02);
    CHECK(trial.block_led(i) == Led::q4);
  }
  CHECK(carried == 1);
}

TEST_CASE("a cart with a gripper, which is no builder's robot, moves a block") {
  Trial trial(scene_text("gripper-cart.yaml"));
  REQUIRE(trial.until(20, "swing"));
  CHECK(trial.block("block 1").p.z > 0.1);
  REQUIRE(trial.until(20, "done"));
  trial.until(1);
  const Vec3 at = (inverse(trial.robot()) * trial.block("block 1")).p;
  CHECK(at.y > 0.1);
  CHECK(at.z == doctest::Approx(0.0275).epsilon(0.02));
}

TEST_CASE("a controller in C++ has the same contract") {
  ControllerFactory factory;
  factory.robot = [](const Scene& scene, const PlacedScene&, std::size_t robot) {
    return std::make_unique<Approach>(scene.robot_models[scene.robots[robot].model]);
  };
  Trial trial("stigc_scene: 1\nrobots: [{file: bebot.yaml}]\nblocks: [{at: [0.4, 0, 0.0275]}]\n", 1,
              factory);
  trial.until(10);
  INFO(trial.log());
  CHECK_FALSE(trial.failed());
  const double left = 0.3725 - 0.044755 - trial.robot().p.x;
  CHECK(left < 0.11);
  CHECK(left > 0.08);
}
