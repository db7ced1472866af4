// SPDX-License-Identifier: MIT
#include "physical/robots/crew.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "physical/dynamics/ticks.h"
#include "physical/robots/crew_history.h"

namespace stig {

namespace {

std::uint32_t number(BodyId id) { return static_cast<std::uint32_t>(id); }

SightShape sight_of(const Shape& shape) {
  if (shape.kind == ShapeKind::sphere) return sight_sphere(shape.half.x);
  return sight_box(shape.half * 2);
}

}  // namespace

Crew::Crew(CrewConfig config, const WorldConfig& world)
    : config_(std::move(config)),
      step_(world.step),
      block_period_(ticks_in(config_.block_period, world.step)) {
  scene_.floor = world.floor;
  for (const BlockModel& model : config_.models) {
    scene_.kinds.push_back(cube_marks({model.side, model.tags.side, model.tags.proud,
                                       model.leds.offset, model.tags.widest, model.leds.widest}));
  }
  std::vector<std::uint32_t> owners(world.bodies.size(), kNobody);
  for (std::size_t i = 0; i < config_.blocks.size(); ++i) {
    owners[number(config_.blocks[i].body)] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = 0; i < config_.robots.size(); ++i) {
    for (const BodyId body : config_.robots[i].body.bodies) {
      owners[number(body)] = crew_owner(i);
    }
  }
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    scene_.obstacles.push_back({shape_of(world.bodies[i].shape), owners[i], {}});
    obstacle_bodies_.push_back(i);
  }
  for (CrewBlock& block : config_.blocks) add_block(std::move(block), false);
  config_.blocks.clear();
  for (CrewRobot& robot : config_.robots) {
    Robot one;
    one.config = std::move(robot);
    const RobotModel& model = *one.config.model;
    one.period = ticks_in(model.control_period, world.step);
    for (const CameraDevice& camera : model.cameras) {
      const auto view = make_view(camera.intrinsics, camera.near, camera.far);
      assert(view);  // the reader has refused cameras that make no sense
      one.views.push_back(*view);
    }
    one.enabled.assign(model.cameras.size(), false);
    one.late_cameras.resize(model.cameras.size());
    one.late_ranges.resize(1);
    one.inbox.resize(model.radios.size());
    one.outbox.resize(model.radios.size());
    robots_.push_back(std::move(one));
  }
  config_.robots.clear();
}

std::uint32_t Crew::shape_of(const Shape& shape) {
  const SightShape made = sight_of(shape);
  for (std::uint32_t i = 0; i < scene_.shapes.size(); ++i) {
    if (scene_.shapes[i].type == made.type && scene_.shapes[i].half == made.half) return i;
  }
  scene_.shapes.push_back(made);
  return static_cast<std::uint32_t>(scene_.shapes.size() - 1);
}

void Crew::add_block(CrewBlock block, bool changed) {
  Block one;
  one.config = std::move(block);
  one.leds.fill(one.config.led);
  one.inbox.resize(kBlockRadios);
  one.outbox.resize(kBlockRadios);
  blocks_.push_back(std::move(one));
  changed_.push_back(changed);
}

void Crew::add(CrewBlock block, const Shape& shape) {
  scene_.obstacles.push_back({shape_of(shape), static_cast<std::uint32_t>(blocks_.size()), {}});
  obstacle_bodies_.push_back(number(block.body));
  add_block(std::move(block), true);
}

void Crew::halt(std::size_t number, std::uint64_t tick) {
  Robot& robot = robots_[number];
  if (robot.failed) return;
  robot.halted = true;
  stop(robot);
  log_.push_back({tick, robot.config.name, root_body(number), "halted", false});
}

void Crew::stop(Robot& robot) {
  robot.failed = true;
  make_safe(robot.devices);
  robot.commands = {};
}

void Crew::set_colour(std::size_t number, Led colour) {
  Block& block = blocks_[number];
  const auto before = block.leds;
  block.leds.fill(colour);
  if (block.leds != before) changed_[number] = true;
}

Pose Crew::robot_pose(const World& world, std::size_t robot) const {
  return pose_of(world, *robots_[robot].config.model, robots_[robot].config.body);
}

bool Crew::all_failed() const {
  return !robots_.empty() &&
         std::all_of(robots_.begin(), robots_.end(), [](const Robot& one) { return one.failed; });
}

BodyId Crew::root_body(std::size_t robot) const {
  return robots_[robot].config.body.bodies[robots_[robot].config.model->root()];
}

Pose Crew::root_pose(std::size_t robot) const {
  const RobotModel& model = *robots_[robot].config.model;
  return model.bodies[model.root()].X_RB;
}

Led Crew::colour(std::size_t block) const {
  std::array<int, 5> shown{};
  for (const Led led : blocks_[block].leds) ++shown[static_cast<std::size_t>(led)];
  return static_cast<Led>(std::max_element(shown.begin(), shown.end()) - shown.begin());
}

std::vector<std::string> Crew::failed_blocks() const {
  std::vector<std::string> out;
  for (const Block& block : blocks_) {
    if (block.failed) out.push_back(block.config.name);
  }
  return out;
}

std::size_t Crew::block_of(BodyId body) const {
  const auto found = std::find_if(blocks_.begin(), blocks_.end(),
                                  [&](const Block& one) { return one.config.body == body; });
  return static_cast<std::size_t>(found - blocks_.begin());
}

std::vector<CrewLine> Crew::take_log() { return std::exchange(log_, {}); }

std::vector<std::size_t> Crew::take_changed() {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    if (changed_[i]) out.push_back(i);
  }
  changed_.assign(blocks_.size(), false);
  return out;
}

std::vector<std::size_t> Crew::take_stepped() { return std::exchange(stepped_, {}); }

void Crew::before_step(World& world) {
  control(world, world.tick());
  for (Robot& robot : robots_) {
    act(world, *robot.config.model, robot.config.body, robot.devices, step_);
  }
}

void Crew::control(World& world, std::uint64_t tick) {
  std::vector<std::size_t> due;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (tick % robots_[i].period == 0) due.push_back(i);
  }
  const bool blocks_due = !blocks_.empty() && tick % block_period_ == 0;
  if (due.empty() && !blocks_due) return;
  if (sends_) carry_messages(world);
  if (!due.empty()) {
    place(scene_, world);
    const SensorIndex index(scene_);
    for (const std::size_t i : due) sense(world, index, i);
  }
  for (const std::size_t i : due) step_robot(world, i);
  if (!blocks_due) return;
  for (std::size_t i = 0; i < blocks_.size(); ++i) step_block(tick, i);
}

/// Its next step, or its first.
ControllerStatus Crew::call(Robot& robot, RobotCommands& commands) const {
  const RobotModel& model = *robot.config.model;
  commands.camera_enabled.resize(model.cameras.size());
  commands.sends.resize(model.radios.size());
  commands.joints.resize(model.actuators.size());
  ControllerStatus status;
  if (!std::exchange(robot.begun, true)) status = robot.config.controller->init(commands);
  if (status.ok) status = robot.config.controller->step(robot.readings, commands);
  return status;
}

void Crew::step_robot(World& world, std::size_t number) {
  Robot& robot = robots_[number];
  if (robot.failed || !robot.config.controller) return;
  if (config_.resumable) robot.history.add(bytes_of(robot.readings));
  RobotCommands commands;
  const ControllerStatus status = call(robot, commands);
  say({world.tick(), robot.config.name, root_body(number), {}, false}, commands.log, status);
  stepped_.push_back(number);
  if (!status.ok) return stop(robot);
  command(robot.devices, *robot.config.model, commands);
  for (std::size_t i = 0; i < commands.camera_enabled.size(); ++i) {
    if (commands.camera_enabled[i]) robot.enabled[i] = *commands.camera_enabled[i];
  }
  robot.outbox = commands.sends;
  robot.outbox.resize(robot.inbox.size());
  for (const auto& messages : robot.outbox) sends_ = sends_ || !messages.empty();
  robot.commands = std::move(commands);
}

ControllerStatus Crew::call(Block& block, std::uint64_t tick, BlockCommands& commands) const {
  BlockReadings readings;
  readings.tick = tick / block_period_;
  readings.time = static_cast<double>(tick) * step_;
  readings.radios = block.inbox;
  if (!block.quiet) {
    for (auto& messages : block.inbox) messages.clear();
    for (auto& messages : block.outbox) messages.clear();
    block.quiet = true;
  }
  commands.sends.resize(kBlockRadios);
  ControllerStatus status;
  if (!std::exchange(block.begun, true)) {
    status = block.config.controller->init(commands);
    // A colour that the scene gives is one that it was set to before.
    if (block.config.led != Led::off) {
      commands.all_leds = static_cast<std::uint8_t>(block.config.led);
    }
  }
  if (status.ok) status = block.config.controller->step(readings, commands);
  return status;
}

void Crew::step_block(std::uint64_t tick, std::size_t number) {
  Block& block = blocks_[number];
  if (block.failed || !block.config.controller) return;
  if (config_.resumable) block.history.add(bytes_of(block.inbox, tick - block.last));
  block.last = tick;
  BlockCommands commands;
  const ControllerStatus status = call(block, tick, commands);
  say({tick, block.config.name, block.config.body, {}, false}, commands.log, status);
  if (!status.ok) {
    block.failed = true;
    return;
  }
  apply(commands, number);
}

void Crew::apply(const BlockCommands& commands, std::size_t number) {
  Block& block = blocks_[number];
  const auto before = block.leds;
  if (commands.all_leds && *commands.all_leds < kLedNames.size()) {
    block.leds.fill(static_cast<Led>(*commands.all_leds));
  }
  for (const auto& [led, colour] : commands.leds) {
    if (led < block.leds.size() && colour < kLedNames.size()) {
      block.leds[led] = static_cast<Led>(colour);
    }
  }
  if (block.leds != before) changed_[number] = true;
  for (std::size_t i = 0; i < std::min(commands.sends.size(), kBlockRadios); ++i) {
    if (commands.sends[i].empty()) continue;
    block.outbox[i] = commands.sends[i];
    block.quiet = false;
    sends_ = true;
  }
}

/// What a step has logged, and why it failed if it did.
void Crew::say(const CrewLine& about, const std::vector<std::string>& lines,
               const ControllerStatus& status) {
  CrewLine line = about;
  for (const std::string& text : lines) {
    line.text = text;
    log_.push_back(line);
  }
  if (status.ok) return;
  line.text = status.error;
  line.failure = true;
  log_.push_back(line);
}

}  // namespace stig
