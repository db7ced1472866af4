// SPDX-License-Identifier: MIT
// A robot with a controller in C++ drives up to a block in a scene: stig::physical_simulation. The
// same run can be recorded, saved and resumed as those of programs in Lua are.
#include <algorithm>
#include <cstdio>
#include <iostream>

#include "physical/simulation/simulation.h"

namespace {

constexpr const char* kScene = R"(
stigc_scene: 1
title: A robot drives up to a block
duration: 20
robots:
  - {file: bebot.yaml, at: [0, 0], heading: 0}
blocks:
  - {at: [0.4, 0, 0.0275], color: Q3, fixed: true}
)";

/// Drives straight on until a rangefinder of the robot has something near. It knows what its
/// readings say and nothing else, so that a run which is resumed can bring it back.
class DriveUp final : public stig::robots::RobotController {
 public:
  stig::robots::ControllerStatus init(stig::robots::RobotCommands&) override { return {}; }
  stig::robots::ControllerStatus step(const stig::robots::RobotReadings& readings,
                                      stig::robots::RobotCommands& commands) override {
    const bool near = std::any_of(
        readings.rangefinders.begin(), readings.rangefinders.end(),
        [](const stig::robots::RangeReading& range) { return range.proximity > kNear; });
    if (near && !stopped_) commands.log.emplace_back("something is near: stop");
    stopped_ = stopped_ || near;
    const double speed = stopped_ ? 0 : 0.05;  // m/s, of the wheels' rims
    commands.wheels = std::pair{speed, speed};
    return {};
  }

 private:
  static constexpr double kNear = 2000;  ///< in the counts of this robot's rangefinders
  bool stopped_ = false;
};

}  // namespace

int main() {
  // Where files that the scene names are looked for; the scene itself is no file here.
  const stig::physics::SceneLoader loader =
      stig::physics::disk_loader(STIG_DATA "/scenes", {STIG_DATA "/robots", STIG_DATA "/blocks"});
  stig::Diagnostics diagnostics;
  const auto scene = stig::physics::read_scene(
      std::make_shared<const stig::SourceFile>("scene.yaml", kScene), loader, diagnostics);
  const auto placed =
      scene ? stig::physics::place_scene(*scene, scene->seed, diagnostics) : std::nullopt;
  std::cerr << stig::to_text(diagnostics);
  if (!placed) return 1;

  // Blocks keep the scene's own programs; the robot gets ours.
  stig::physics::ControllerFactory controllers = stig::physics::lua_controllers();
  controllers.robot = [](const stig::physics::Scene&, const stig::physics::PlacedScene&,
                         std::size_t) { return std::make_unique<DriveUp>(); };
  stig::physics::Simulation run(*scene, *placed, /*resumable=*/true, controllers);
  stig::physics::RunHooks hooks;
  hooks.on_line = [](const stig::physics::CrewLine& line) {
    std::printf("%s: %s\n", line.who.c_str(), line.text.c_str());
  };
  run.until(scene->duration, hooks);
  std::printf("driven: %.2f m\n", run.driven(0));
}
