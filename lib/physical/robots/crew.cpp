// SPDX-License-Identifier: MIT
// The order within a tick is what makes runs repeatable: messages are carried first, then every
// robot that is due reads the same state of the world, and only then do controllers run and
// command. So no controller sees what another does in the same tick, whatever their numbers.
#include "physical/robots/crew.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "physical/dynamics/ticks.h"
#include "physical/robots/crew_history.h"

namespace stig::physics {

Crew::Crew(CrewConfig config, const WorldConfig& world)
    : config_(std::move(config)),
      step_(world.step),
      block_period_(ticks_in(config_.block_period, world.step)),
      senses_(config_, world),
      signals_(config_),
      robots_(config_.robots.size()),
      blocks_(config_.blocks.size()) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    // Periods in whole steps of physics.
    robots_[i].period = ticks_in(model(i).control_period, world.step);
  }
}

// A block that came while the run went on: its signals count as changed, for the trace.
void Crew::add(CrewBlock block, const Shape& shape) {
  senses_.add_block(blocks_.size(), block, shape);
  signals_.add_block(block, true);
  blocks_.emplace_back();
  config_.blocks.push_back(std::move(block));
}

void Crew::halt(std::size_t number, std::uint64_t tick) {
  assert(number < robots_.size());
  Robot& robot = robots_[number];
  // Halted once or failed: nothing more to stop.
  if (robot.failed) return;
  robot.halted = true;
  stop(robot);
  log_.push_back({tick, robot_name(number), root_body(number), "halted", false});
}

bool Crew::mend(std::size_t number, std::uint64_t tick) {
  assert(number < robots_.size());
  Robot& robot = robots_[number];
  if (!robot.halted) return false;
  robot.halted = robot.failed = false;
  log_.push_back({tick, robot_name(number), root_body(number), "mended", false});
  return true;
}

void Crew::stop(Robot& robot) {
  robot.failed = true;
  // Wheels and lift stop and magnets go off, since no program is left that could do so.
  make_safe(robot.devices);
  robot.commands = {};
}

Pose Crew::robot_pose(const World& world, std::size_t robot) const {
  assert(robot < robots_.size());
  return pose_of(world, model(robot), config_.robots[robot].body);
}

bool Crew::all_failed() const {
  return !robots_.empty() &&
         std::all_of(robots_.begin(), robots_.end(), [](const Robot& one) { return one.failed; });
}

// Whether all have failed that there are. Halting is a script's decision and no failure. Programs
// of blocks count only where no robot has one.
bool Crew::programs_failed() const {
  std::size_t robots = 0, blocks = 0;
  bool robots_failed = true, blocks_failed = true;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (!config_.robots[i].controller) continue;
    ++robots;
    robots_failed = robots_failed && robots_[i].failed && !robots_[i].halted;
  }
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (!config_.blocks[i].controller) continue;
    ++blocks;
    blocks_failed = blocks_failed && blocks_[i].failed;
  }
  return robots > 0 ? robots_failed : blocks > 0 && blocks_failed;
}

BodyId Crew::root_body(std::size_t robot) const {
  return config_.robots[robot].body.bodies[model(robot).root()];
}

// The robot's frame is not that of its root body; the model says how they lie.
Pose Crew::root_pose(std::size_t robot) const {
  return model(robot).bodies[model(robot).root()].X_RB;
}

std::vector<std::string> Crew::failed_blocks() const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (blocks_[i].failed) out.push_back(config_.blocks[i].name);
  }
  return out;
}

std::size_t Crew::block_of(BodyId body) const {
  const auto& blocks = config_.blocks;
  const auto found = std::find_if(blocks.begin(), blocks.end(),
                                  [&](const CrewBlock& one) { return one.body == body; });
  return static_cast<std::size_t>(found - blocks.begin());
}

std::vector<CrewLine> Crew::take_log() { return std::exchange(log_, {}); }

// Which robots made a step since it was asked last: their `show` goes into the trace.
std::vector<std::size_t> Crew::take_stepped() { return std::exchange(stepped_, {}); }

void Crew::before_step(World& world) {
  control(world, world.tick());
  // Devices act in every step of physics, controllers now and then: motors ramp in between.
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    act(world, model(i), config_.robots[i].body, robots_[i].devices, step_);
  }
}

void Crew::control(World& world, std::uint64_t tick) {
  std::vector<std::size_t> due;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (tick % robots_[i].period == 0) due.push_back(i);
  }
  const bool blocks_due = !blocks_.empty() && tick % block_period_ == 0;
  if (due.empty() && !blocks_due) return;
  if (signals_.carry(config_, world)) {
    // Who has no working program does not collect messages for ever.
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (robots_[i].failed || !config_.robots[i].controller) signals_.forget_heard(i);
    }
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (blocks_[i].failed || !config_.blocks[i].controller) signals_.limit_heard_by_block(i);
    }
  }
  if (!due.empty()) {
    // One index of all obstacles for all robots that are due: it is what sensing costs.
    const SensorIndex index = senses_.look(config_, world, signals_);
    for (const std::size_t i : due) sense(world, index, i);
  }
  for (const std::size_t i : due) step_robot(world, i);
  if (!blocks_due) return;
  for (std::size_t i = 0; i < blocks_.size(); ++i) step_block(tick, i);
}

void Crew::sense(const World& world, const SensorIndex& index, std::size_t number) {
  Robot& robot = robots_[number];
  if (robot.failed) return;
  RobotReadings& out = robot.readings;
  // Ticks of its own controller, not of the world.
  out.tick = world.tick() / robot.period;
  out.time = world.time();
  senses_.sense(config_, world, index, number, out);
  out.radios = signals_.take_heard(number);
  read(world, model(number), config_.robots[number].body, robot.devices, out);
  count_wheels(config_, world, number, out);
}

/// Its next step, or its first.
ControllerStatus Crew::call_robot(std::size_t number, RobotCommands& commands) {
  Robot& robot = robots_[number];
  RobotController& controller = *config_.robots[number].controller;
  // Lists have an entry for each device before the controller sees them, so that it may set one by
  // its number.
  commands.camera_enabled.resize(model(number).cameras.size());
  commands.sends.resize(model(number).radios.size());
  commands.joints.resize(model(number).actuators.size());
  ControllerStatus status;
  if (!std::exchange(robot.begun, true)) status = controller.init(commands);
  if (status.ok) status = controller.step(robot.readings, commands);
  return status;
}

void Crew::step_robot(World& world, std::size_t number) {
  Robot& robot = robots_[number];
  if (robot.failed || !config_.robots[number].controller) return;
  // What it is about to read is what it is fed when it is brought back.
  if (config_.resumable) robot.history.add(bytes_of(robot.readings, model(number)));
  RobotCommands commands;
  const ControllerStatus status = call_robot(number, commands);
  // The log is kept even of the step that failed.
  say({world.tick(), robot_name(number), root_body(number), {}, false}, commands.log, status);
  stepped_.push_back(number);
  if (!status.ok) return stop(robot);
  command(robot.devices, model(number), commands);
  senses_.obey(number, commands);
  signals_.send(number, commands.sends);
  robot.commands = std::move(commands);
}

BlockReadings Crew::block_readings(std::uint64_t tick,
                                   std::vector<std::vector<Message>> heard) const {
  BlockReadings out;
  out.tick = tick / block_period_;
  out.time = static_cast<double>(tick) * step_;
  out.radios = std::move(heard);
  return out;
}

namespace {

void show(Led what, BlockCommands& commands) {
  const BlockLeds leds = leds_showing(what);
  commands.leds.clear();
  for (std::size_t i = 0; i < leds.size(); ++i) {
    commands.leds.emplace_back(i, static_cast<std::uint8_t>(leds[i]));
  }
}

}  // namespace

ControllerStatus Crew::call_block(std::size_t number, const BlockReadings& readings,
                                  BlockCommands& commands) {
  const CrewBlock& config = config_.blocks[number];
  commands.sends.resize(kBlockRadios);
  ControllerStatus status;
  if (!std::exchange(blocks_[number].begun, true)) {
    status = config.controller->init(commands);
    // A colour that the scene gives counts as commanded, so that it holds against the program's
    // init, which knows of no scene.
    if (config.led != Led::off) show(config.led, commands);
  }
  if (status.ok) status = config.controller->step(readings, commands);
  return status;
}

void Crew::step_block(std::uint64_t tick, std::size_t number) {
  Block& block = blocks_[number];
  const CrewBlock& config = config_.blocks[number];
  if (block.failed || !config.controller) return;
  const BlockReadings readings = block_readings(tick, signals_.take_heard_by_block(number));
  // Relative times are small numbers: histories of thousands of blocks stay small.
  if (config_.resumable) block.history.add(bytes_of(readings.radios, tick - block.last));
  block.last = tick;
  BlockCommands commands;
  const ControllerStatus status = call_block(number, readings, commands);
  say({tick, config.name, config.body, {}, false}, commands.log, status);
  if (status.ok) {
    signals_.apply(number, commands);
  } else {
    block.failed = true;
  }
}

/// What a step has logged, and why it failed if it did.
void Crew::say(const CrewLine& about, const std::vector<std::string>& lines,
               const ControllerStatus& status) {
  CrewLine line = about;
  for (const std::string& text : lines) {
    line.text = text;
    // print puts a tab between what it is given, and a traceback before its lines.
    std::replace(line.text.begin(), line.text.end(), '\t', ' ');
    log_.push_back(line);
  }
  if (status.ok) return;
  line.text = status.error;
  line.failure = true;
  log_.push_back(line);
}

}  // namespace stig::physics
