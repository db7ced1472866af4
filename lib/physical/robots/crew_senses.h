// SPDX-License-Identifier: MIT
// What the robots of a crew perceive: their cameras and rangefinders, the scene that those look
// at, and sensors that perceive nothing but their own body.
#pragma once

#include <vector>

#include "physical/robots/crew_signals.h"
#include "physical/robots/uses.h"
#include "physical/sensors/sensor_scene.h"
#include "sensing/camera_view.h"

namespace stig::physics {

/// The sensors of one robot.
struct RobotSenses {
  std::vector<CameraView> views;
  std::vector<bool> enabled;  ///< cameras
  bool dark = false;          ///< no light comes into its cameras
  std::vector<Late<CameraReading>> late_cameras;
  std::vector<Late<std::vector<RangeReading>>> late_ranges;

  static void members(auto& each, auto& senses) {
    each.list(senses.enabled);
    for (auto& late : senses.late_cameras) each.list(late.on_the_way);
    for (auto& late : senses.late_ranges) each.list(late.on_the_way);
  }
};

class CrewSenses {
 public:
  CrewSenses(const CrewConfig& config, const WorldConfig& world);
  /// A block that was brought in while the world ran, by its number.
  void add_block(std::size_t number, const CrewBlock& block, const Shape& shape);

  /// Looks at everything as it stands now: for `sense`, as long as nothing moves.
  SensorIndex look(const CrewConfig& config, const World& world, const CrewSignals& signals);
  /// Fills in what sensors read.
  void sense(const CrewConfig& config, const World& world, const SensorIndex& index,
             std::size_t robot, RobotReadings& readings);
  /// Covers a robot's cameras, or uncovers them: their pictures are empty as long as they are dark.
  void set_dark(std::size_t robot, bool dark) { robots_[robot].dark = dark; }
  /// Switches cameras on and off.
  void obey(std::size_t robot, const RobotCommands& commands);

  /// What can be perceived now.
  SensorScene scene(const CrewConfig& config, const World& world, const CrewSignals& signals) const;

  // Members, for a crew's list of them.
  static void robot_members(auto& each, auto& senses, std::size_t robot) {
    each_member(each, senses.robots_[robot]);
  }
  static auto& dark(auto& senses, std::size_t robot) { return senses.robots_[robot].dark; }
  /// Lists as long as the robots' devices are many, as after bytes from outside they might not be.
  bool fits(const CrewConfig& config) const;

 private:
  CameraReading see(const CrewConfig& config, const World& world, const SensorIndex& index,
                    std::size_t robot, std::size_t camera) const;
  std::vector<RangeReading> feel(const CrewConfig& config, const World& world,
                                 const SensorIndex& index, std::size_t robot) const;
  void place(SensorScene& scene, const CrewConfig& config, const World& world,
             const CrewSignals& signals) const;
  void add_obstacle(BodyId body, SightShape shape, std::uint32_t owner);

  std::vector<RobotSenses> robots_;
  SensorScene scene_;
  std::vector<BodyId> obstacle_bodies_;  ///< of each obstacle
};

/// Makes true speeds of rims what encoders tell.
void count_wheels(const CrewConfig& config, const World& world, std::size_t robot,
                  RobotReadings& readings);

/// From where a camera looks.
Pose camera_pose(const World& world, const CrewRobot& robot, std::size_t camera);

}  // namespace stig::physics
