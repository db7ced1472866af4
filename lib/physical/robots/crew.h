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
//
// The crew keeps the order and calls the programs; what they perceive is in crew_senses.h, what
// they tell each other, by radio and LEDs, in crew_signals.h.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "physical/robots/crew_config.h"
#include "physical/robots/crew_senses.h"
#include "physical/robots/crew_signals.h"
#include "physical/robots/reading_history.h"
#include "physical/robots/uses.h"

namespace stig::physics {

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
  const std::string& robot_name(std::size_t robot) const { return config_.robots[robot].name; }
  Pose robot_pose(const World& world, std::size_t robot) const;
  bool failed(std::size_t robot) const { return robots_[robot].failed; }
  /// Failed because somebody halted it.
  bool halted(std::size_t robot) const { return robots_[robot].halted; }
  /// Every robot; false when there is none.
  bool all_failed() const;
  /// Every robot's program, of those that have one and none halted; where no robot has one, every
  /// block's. False when there is no program.
  bool programs_failed() const;
  /// What a robot read and commanded in its last step.
  const RobotReadings& readings(std::size_t robot) const { return robots_[robot].readings; }
  const RobotCommands& commands(std::size_t robot) const { return robots_[robot].commands; }
  const BlockLeds& leds(std::size_t block) const { return signals_.leds(block); }
  const RobotModel& model(std::size_t robot) const { return *config_.robots[robot].model; }
  /// What sensors can perceive now, and from where a camera looks.
  SensorScene sensor_scene(const World& world) const {
    return senses_.scene(config_, world, signals_);
  }
  Pose camera_pose(const World& world, std::size_t robot, std::size_t camera) const {
    return physics::camera_pose(world, config_.robots[robot], camera);
  }
  /// The body that a robot's file takes for its root, and its pose in the robot's frame.
  BodyId root_body(std::size_t robot) const;
  Pose root_pose(std::size_t robot) const;
  BodyId block_body(std::size_t block) const { return config_.blocks[block].body; }
  /// What its LEDs show.
  Led colour(std::size_t block) const { return signals_.colour(block); }
  /// Names of blocks whose programs have failed.
  std::vector<std::string> failed_blocks() const;
  /// The block of a body, or none: blocks().
  std::size_t block_of(BodyId body) const;

  /// A block that was brought in while the world ran.
  void add(CrewBlock block, const Shape& shape);

  /// As if its program had failed in this tick: it is not called again, its motors stand.
  void halt(std::size_t robot, std::uint64_t tick);
  /// One that was halted goes on: its program is called again, where it was. False when it is not
  /// halted.
  bool mend(std::size_t robot, std::uint64_t tick);
  /// All LEDs of a block, until its program sets them.
  void set_colour(std::size_t block, Led colour) { signals_.set_colour(block, colour); }
  /// Faults of devices, and their ends. Programs learn of them by what they read, or do not.
  void set_dark(std::size_t robot, bool dark) { senses_.set_dark(robot, dark); }
  void set_radio(std::size_t robot, bool alive) { signals_.set_radio(robot, alive); }
  void set_radio_of_block(std::size_t block, bool alive) {
    signals_.set_radio_of_block(block, alive);
  }
  void set_leds(std::size_t block, LedSet which, bool alive) {
    signals_.set_leds(block, which, alive);
  }
  /// Whether all LEDs of a body that is a block are dead.
  bool leds_dead(BodyId body) const;
  /// What of this is broken now: a sentence each, robots first.
  std::vector<std::string> broken() const;

  /// Lines since the last call.
  std::vector<CrewLine> take_log();
  /// Blocks whose LEDs have changed since the last call, rising.
  std::vector<std::size_t> take_changed() { return signals_.take_changed(); }
  /// Robots whose programs have stepped since the last call, rising.
  std::vector<std::size_t> take_stepped();

  /// Devices, LEDs, messages and readings on their way; all that the next tick depends on but
  /// the programs' own states.
  std::string state() const;
  /// With what the programs have read, from which they can be brought back. Asserts that the
  /// crew is resumable.
  std::string checkpoint() const;
  /// Takes up a checkpoint in a crew as it was made, with blocks that came later added again: feeds
  /// its programs what they have read, without carrying out what they command. False when the
  /// bytes are no checkpoint of this crew; it is then of no use any more.
  bool resume(std::string_view checkpoint);

 private:
  struct Robot {
    std::uint64_t period = 1;  ///< world ticks
    bool begun = false, failed = false, halted = false;
    RobotDevices devices;
    RobotReadings readings;
    RobotCommands commands;
    ReadingHistory history;
  };
  struct Block {
    bool begun = false, failed = false;
    std::uint64_t last = 0;  ///< tick of the world in which it stepped last
    ReadingHistory history;
  };

  void control(World& world, std::uint64_t tick);
  void sense(const World& world, const SensorIndex& index, std::size_t robot);
  void step_robot(World& world, std::size_t robot);
  void step_block(std::uint64_t tick, std::size_t block);
  static void stop(Robot& robot);
  ControllerStatus call_robot(std::size_t robot, RobotCommands& commands);
  ControllerStatus call_block(std::size_t block, const BlockReadings& readings,
                              BlockCommands& commands);
  BlockReadings block_readings(std::uint64_t tick, std::vector<std::vector<Message>> heard) const;
  void say(const CrewLine& about, const std::vector<std::string>& lines,
           const ControllerStatus& status);
  bool fits() const;
  bool bring_back_robot(std::size_t robot);
  bool bring_back_block(std::size_t block);
  static void crew_members(auto& each, auto& crew);
  static void faults(auto& each, auto& crew);
  static void histories(auto& each, auto& crew);
  bool faulty() const;

  CrewConfig config_;
  double step_ = 0;
  std::uint64_t block_period_ = 1;
  CrewSenses senses_;
  CrewSignals signals_;
  std::vector<Robot> robots_;  ///< as those of the configuration
  std::vector<Block> blocks_;
  std::vector<CrewLine> log_;
  std::vector<std::size_t> stepped_;
};

}  // namespace stig::physics
