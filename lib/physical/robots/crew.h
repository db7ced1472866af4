// SPDX-License-Identifier: MIT
// Robots and blocks with programs, at work in a world.
//
// The order of a control tick:
//
//     media     messages sent in the last tick reach the radios near their senders
//     sense     cameras, rangefinders, radios, encoders: of the world as it stands now
//     control   every program steps once, on its own readings alone
//     act       commands go to motors, magnets, LEDs and radios
//     physics   the world steps until the next tick
//
// All robots sense before any acts, so their order does not matter. A program learns about
// the world only through its readings; what it commands acts only through motors, magnets and
// radio. One that fails is not called again, and its robot is made safe.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "physical/dynamics/world.h"
#include "physical/robots/led.h"
#include "physical/robots/reading_history.h"
#include "physical/robots/robot_body.h"
#include "physical/sensors/sensor_noise.h"
#include "physical/sensors/sensor_scene.h"
#include "robots/block.h"
#include "robots/controller.h"
#include "sensing/camera_view.h"

namespace stig {

struct CrewRobot {
  std::string name;
  const RobotModel* model = nullptr;  ///< must outlive the crew
  RobotBody body;
  std::unique_ptr<RobotController> controller;
  CameraNoise camera_noise;
  RangeNoise range_noise;
};

struct CrewBlock {
  std::string name;
  BodyId body{};
  std::size_t model = 0;                        ///< in CrewConfig::models
  Led led = Led::off;                           ///< of all its LEDs at the start
  std::unique_ptr<BlockController> controller;  ///< none: its LEDs stay as they are
};

struct CrewConfig {
  std::uint64_t seed = 1;
  double block_period = 0.2;  ///< s between steps of blocks' programs
  bool lights = true;         ///< false: no LED shines
  bool resumable = true;      ///< keep what programs read, so that the crew can be brought back
  std::vector<BlockModel> models;  ///< of the blocks
  std::vector<CrewRobot> robots;
  std::vector<CrewBlock> blocks;
};

/// Something that a program said, or that ended it.
struct CrewLine {
  std::uint64_t tick = 0;  ///< of the world
  std::string who;
  BodyId body{};  ///< of a block, or a robot's root
  std::string text;
  bool failure = false;
};

class Crew {
 public:
  /// The world that it works in, for shapes and steps; of the bodies in `config` no two alike.
  Crew(CrewConfig config, const WorldConfig& world);

  /// Before every step of the world: a control tick where one is due, and motors.
  void before_step(World& world);

  bool resumable() const { return config_.resumable; }
  std::size_t robots() const { return robots_.size(); }
  std::size_t blocks() const { return blocks_.size(); }
  const std::string& robot_name(std::size_t robot) const { return robots_[robot].config.name; }
  Pose robot_pose(const World& world, std::size_t robot) const;
  bool failed(std::size_t robot) const { return robots_[robot].failed; }
  /// Failed because somebody halted it.
  bool halted(std::size_t robot) const { return robots_[robot].halted; }
  /// Every robot; false when there is none.
  bool all_failed() const;
  /// What a robot read and commanded in its last step.
  const RobotReadings& readings(std::size_t robot) const { return robots_[robot].readings; }
  const RobotCommands& commands(std::size_t robot) const { return robots_[robot].commands; }
  const std::array<Led, kBlockLeds>& leds(std::size_t block) const { return blocks_[block].leds; }
  const RobotModel& model(std::size_t robot) const { return *robots_[robot].config.model; }
  /// What sensors can perceive now, and from where a camera looks.
  SensorScene sensor_scene(const World& world) const;
  Pose camera_pose(const World& world, std::size_t robot, std::size_t camera) const;
  /// The body that a robot's file takes for its root, and its pose in the robot's frame.
  BodyId root_body(std::size_t robot) const;
  Pose root_pose(std::size_t robot) const;
  BodyId block_body(std::size_t block) const { return blocks_[block].config.body; }
  /// The colour that most of its LEDs show.
  Led colour(std::size_t block) const;
  /// Names of blocks whose programs have failed.
  std::vector<std::string> failed_blocks() const;
  /// The block of a body, or none: blocks().
  std::size_t block_of(BodyId body) const;

  /// A block that was brought in while the world ran.
  void add(CrewBlock block, const Shape& shape);

  /// As if its program had failed in this tick: it is not called again, its motors stand.
  void halt(std::size_t robot, std::uint64_t tick);
  /// All LEDs of a block, until its program sets them.
  void set_colour(std::size_t block, Led colour);

  /// Lines since the last call.
  std::vector<CrewLine> take_log();
  /// Blocks whose LEDs have changed since the last call, rising.
  std::vector<std::size_t> take_changed();
  /// Robots whose programs have stepped since the last call, rising.
  std::vector<std::size_t> take_stepped();

  /// Devices, LEDs, messages and readings on their way; all that the next tick depends on but
  /// the programs' own states.
  std::string state() const;
  /// With what the programs have read, from which they can be brought back. Asserts that the
  /// crew is resumable.
  std::string checkpoint() const;
  /// Of a crew as it was made, with blocks that came later added again: feeds its programs what
  /// they have read, without carrying out what they command. False when the bytes are no
  /// checkpoint of this crew; it is then of no use any more.
  bool resume(std::string_view checkpoint);

 private:
  struct Robot {
    CrewRobot config;
    std::uint64_t period = 1;  ///< world ticks
    bool begun = false, failed = false, halted = false;
    RobotDevices devices;
    RobotReadings readings;
    RobotCommands commands;
    std::vector<CameraView> views;
    std::vector<bool> enabled;  ///< cameras
    std::vector<Late<CameraReading>> late_cameras;
    std::vector<Late<std::vector<RangeReading>>> late_ranges;
    std::vector<std::vector<Message>> inbox, outbox;  ///< a radio each
    ReadingHistory history;
  };
  struct Block {
    CrewBlock config;
    bool begun = false, failed = false;
    std::array<Led, kBlockLeds> leds{};
    std::vector<std::vector<Message>> inbox, outbox;
    bool quiet = true;       ///< nothing in inbox or outbox
    std::uint64_t last = 0;  ///< tick of the world in which it stepped last
    ReadingHistory history;
  };

  void add_block(CrewBlock block, bool changed);
  void control(World& world, std::uint64_t tick);
  void carry_messages(const World& world);
  void place(SensorScene& scene, const World& world) const;
  void sense(const World& world, const SensorIndex& index, std::size_t robot);
  CameraReading see(const World& world, const SensorIndex& index, std::size_t robot,
                    std::size_t camera);
  std::vector<RangeReading> feel(const World& world, const SensorIndex& index, std::size_t robot);
  void step_robot(World& world, std::size_t robot);
  static void stop(Robot& robot);
  void step_block(std::uint64_t tick, std::size_t block);
  ControllerStatus call(Robot& robot, RobotCommands& commands) const;
  ControllerStatus call(Block& block, std::uint64_t tick, BlockCommands& commands) const;
  bool bring_back(Robot& robot) const;
  bool bring_back(Block& block) const;
  template <class Each>
  static void robot_members(Each& each, auto& robot);
  template <class Each>
  static void block_members(Each& each, auto& block);
  template <class Each>
  static void crew_members(Each& each, auto& crew);
  template <class Each>
  static void histories(Each& each, auto& crew);
  bool fits(const Robot& robot) const;
  void apply(const BlockCommands& commands, std::size_t block);
  void say(const CrewLine& about, const std::vector<std::string>& lines,
           const ControllerStatus& status);
  std::uint32_t shape_of(const Shape& shape);
  /// Owner of a robot's obstacles; blocks' are their numbers, and loose bodies have none.
  static std::uint32_t crew_owner(std::size_t robot) {
    return kNobody - 1 - static_cast<std::uint32_t>(robot);
  }
  static constexpr std::uint32_t kNobody = 0xffffffff;

  CrewConfig config_;
  double step_ = 0;
  std::uint64_t block_period_ = 1;
  std::vector<Robot> robots_;
  std::vector<Block> blocks_;
  SensorScene scene_;
  std::vector<std::uint32_t> obstacle_bodies_;  ///< of each obstacle
  std::vector<CrewLine> log_;
  std::vector<bool> changed_;
  std::vector<std::size_t> stepped_;
  bool sends_ = false;  ///< somebody has sent since messages were carried
};

}  // namespace stig
