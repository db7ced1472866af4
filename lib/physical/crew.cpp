// SPDX-License-Identifier: MIT
#include "physical/crew.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "physical/camera_reading.h"
#include "physical/radio_medium.h"
#include "physical/range_sensor.h"

namespace stig {

namespace {

std::uint64_t ticks_in(double seconds, double step) {
  return static_cast<std::uint64_t>(std::max<long long>(1, std::llround(seconds / step)));
}

std::uint32_t number(BodyId id) { return static_cast<std::uint32_t>(id); }

/// Owners of obstacles and marks: blocks and robots count in one row, loose bodies have none.
constexpr std::uint32_t kNobody = 0xffffffff;

SightShape sight_of(const Shape& shape) {
  if (shape.kind == ShapeKind::sphere) return sight_sphere(shape.half.x);
  return sight_box(shape.half * 2);
}

/// Middles of a cube's faces, as its radios are numbered: see cube_marks.
constexpr std::array<Vec3, kBlockRadios> kFaceNormals = {
    Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}};

Rgb light_of(Led led) { return led == Led::off ? Rgb{} : rgb_of(led); }

}  // namespace

Crew::Crew(CrewConfig config, const WorldConfig& world)
    : config_(std::move(config)),
      step_(world.step),
      block_period_(ticks_in(config_.block_period, world.step)) {
  scene_.floor = world.floor;
  scene_.kinds.push_back(cube_marks(config_.faces));
  std::vector<std::uint32_t> owners(world.bodies.size(), kNobody);
  for (std::size_t i = 0; i < config_.blocks.size(); ++i) {
    owners[number(config_.blocks[i].body)] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = 0; i < config_.robots.size(); ++i) {
    for (const BodyId body : config_.robots[i].body.bodies) {
      owners[number(body)] = kNobody - 1 - static_cast<std::uint32_t>(i);
    }
  }
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    scene_.obstacles.push_back({shape_of(world.bodies[i].shape), owners[i], {}});
    obstacle_bodies_.push_back(i);
  }
  for (CrewBlock& block : config_.blocks) {
    Block one;
    one.config = std::move(block);
    one.leds.fill(one.config.led);
    one.inbox.resize(kBlockRadios);
    one.outbox.resize(kBlockRadios);
    blocks_.push_back(std::move(one));
  }
  config_.blocks.clear();
  changed_.assign(blocks_.size(), false);
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
    // As the real one: on until it is disabled.
    one.enabled.assign(model.cameras.size(), true);
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

void Crew::add(CrewBlock block, const Shape& shape) {
  scene_.obstacles.push_back({shape_of(shape), static_cast<std::uint32_t>(blocks_.size()), {}});
  obstacle_bodies_.push_back(number(block.body));
  Block one;
  one.config = std::move(block);
  one.leds.fill(one.config.led);
  one.inbox.resize(kBlockRadios);
  one.outbox.resize(kBlockRadios);
  blocks_.push_back(std::move(one));
  changed_.push_back(true);
}

Pose Crew::robot_pose(const World& world, std::size_t robot) const {
  return pose_of(world, *robots_[robot].config.model, robots_[robot].config.body);
}

Led Crew::colour(std::size_t block) const {
  std::array<int, 5> shown{};
  for (const Led led : blocks_[block].leds) ++shown[static_cast<std::size_t>(led)];
  return static_cast<Led>(std::max_element(shown.begin(), shown.end()) - shown.begin());
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
    place_sensor_scene(world);
    const SensorIndex index(scene_);
    for (const std::size_t i : due) sense(world, index, i);
  }
  for (const std::size_t i : due) step_robot(world, i);
  if (!blocks_due) return;
  for (std::size_t i = 0; i < blocks_.size(); ++i) step_block(tick, i);
}

void Crew::place_sensor_scene(const World& world) {
  for (std::size_t i = 0; i < scene_.obstacles.size(); ++i) {
    scene_.obstacles[i].X_WS = world.state(BodyId{obstacle_bodies_[i]}).X_WB;
  }
  scene_.marked.resize(blocks_.size());
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    MarkedBody& marked = scene_.marked[i];
    marked.owner = static_cast<std::uint32_t>(i);
    marked.X_WB = world.state(blocks_[i].config.body).X_WB;
    marked.leds.clear();
    if (!config_.lights) continue;
    for (const Led led : blocks_[i].leds) marked.leds.push_back(light_of(led));
  }
}

void Crew::sense(const World& world, const SensorIndex& index, std::size_t number) {
  Robot& robot = robots_[number];
  if (robot.failed) return;
  const RobotModel& model = *robot.config.model;
  RobotReadings& out = robot.readings;
  out.tick = world.tick() / robot.period;
  out.time = world.time();
  out.cameras.resize(model.cameras.size());
  for (std::size_t i = 0; i < model.cameras.size(); ++i) {
    out.cameras[i] =
        robot.late_cameras[i].pass(see(world, index, number, i), robot.config.camera_noise.latency);
  }
  out.rangefinders =
      robot.late_ranges[0].pass(feel(world, index, number), robot.config.range_noise.latency);
  out.rangefinders.resize(model.rangefinders.size());
  out.radios = std::exchange(robot.inbox, std::vector<std::vector<Message>>(model.radios.size()));
  read(world, model, robot.config.body, robot.devices, out);
}

CameraReading Crew::see(const World& world, const SensorIndex& index, std::size_t number,
                        std::size_t camera) {
  const Robot& robot = robots_[number];
  const CameraDevice& device = robot.config.model->cameras[camera];
  const Pose X_WC = pose_of(world, robot.config.body, device.body) * device.X_BC;
  CameraReading out;
  if (robot.enabled[camera]) {
    const NoiseAddress address{config_.seed, static_cast<std::uint32_t>(number),
                               static_cast<std::uint32_t>(camera), world.tick()};
    out = read_camera(scene_, look(index, robot.views[camera], X_WC), robot.views[camera],
                      robot.config.camera_noise, address);
  }
  out.enabled = robot.enabled[camera];
  out.timestamp = world.time();
  out.X_RC = inverse(robot_pose(world, number)) * X_WC;
  return out;
}

std::vector<RangeReading> Crew::feel(const World& world, const SensorIndex& index,
                                     std::size_t number) {
  const Robot& robot = robots_[number];
  const RobotModel& model = *robot.config.model;
  std::vector<RangeReading> out;
  for (std::size_t i = 0; i < model.rangefinders.size(); ++i) {
    const RangeDevice& device = model.rangefinders[i];
    const NoiseAddress address{config_.seed, static_cast<std::uint32_t>(number),
                               static_cast<std::uint32_t>(model.cameras.size() + i), world.tick()};
    const auto owner = kNobody - 1 - static_cast<std::uint32_t>(number);
    out.push_back({read_range(index, device, pose_of(world, robot.config.body, device.body), owner,
                              robot.config.range_noise, address),
                   0});
  }
  return out;
}

void Crew::step_robot(World& world, std::size_t number) {
  Robot& robot = robots_[number];
  if (robot.failed || !robot.config.controller) return;
  const RobotModel& model = *robot.config.model;
  RobotCommands commands;
  commands.camera_enabled.resize(model.cameras.size());
  commands.sends.resize(model.radios.size());
  commands.joints.resize(model.actuators.size());
  ControllerStatus status;
  if (!robot.begun) {
    robot.begun = true;
    status = robot.config.controller->init(commands);
  }
  if (status.ok) status = robot.config.controller->step(robot.readings, commands);
  say(world.tick(), robot.config.name, commands.log);
  if (!status.ok) {
    robot.failed = true;
    make_safe(robot.devices);
    robot.commands = {};
    return fail(world.tick(), robot.config.name, status.error);
  }
  command(robot.devices, model, commands);
  for (std::size_t i = 0; i < commands.camera_enabled.size(); ++i) {
    if (commands.camera_enabled[i]) robot.enabled[i] = *commands.camera_enabled[i];
  }
  robot.outbox = commands.sends;
  robot.outbox.resize(model.radios.size());
  for (const auto& messages : robot.outbox) sends_ = sends_ || !messages.empty();
  robot.commands = std::move(commands);
}

void Crew::step_block(std::uint64_t tick, std::size_t number) {
  Block& block = blocks_[number];
  if (block.failed || !block.config.controller) return;
  BlockReadings readings;
  readings.tick = tick / block_period_;
  readings.time = static_cast<double>(tick) * step_;
  readings.radios = block.inbox;
  if (!block.quiet) {
    for (auto& messages : block.inbox) messages.clear();
    for (auto& messages : block.outbox) messages.clear();
    block.quiet = true;
  }
  BlockCommands commands;
  commands.sends.resize(kBlockRadios);
  ControllerStatus status;
  if (!block.begun) {
    block.begun = true;
    status = block.config.controller->init(commands);
    // A colour that the scene gives is one that it was set to before.
    if (block.config.led != Led::off) {
      commands.all_leds = static_cast<std::uint8_t>(block.config.led);
    }
  }
  if (status.ok) status = block.config.controller->step(readings, commands);
  say(tick, block.config.name, commands.log);
  if (!status.ok) {
    block.failed = true;
    return fail(tick, block.config.name, status.error);
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

/// Messages reach radios where they are now, at the end of the tick in which they were sent.
void Crew::carry_messages(const World& world) {
  std::vector<Radio> radios;
  std::vector<std::vector<Message>> sends;
  for (Robot& robot : robots_) {
    const RobotModel& model = *robot.config.model;
    for (std::size_t i = 0; i < model.radios.size(); ++i) {
      const RadioDevice& device = model.radios[i];
      radios.push_back({pose_of(world, robot.config.body, device.body) * device.p_B, device.range});
      sends.push_back(std::exchange(robot.outbox[i], {}));
    }
  }
  const double reach = config_.faces.cube_side / 2 - config_.radio_depth;
  for (Block& block : blocks_) {
    const Pose X_WB = world.state(block.config.body).X_WB;
    for (std::size_t i = 0; i < kBlockRadios; ++i) {
      radios.push_back({X_WB * (kFaceNormals[i] * reach), config_.radio_range});
      sends.push_back(std::exchange(block.outbox[i], {}));
    }
  }
  const auto heard = carry(radios, sends);
  auto next = heard.begin();
  const auto take = [&next](std::vector<std::vector<Message>>& inbox) {
    bool any = false;
    for (auto& messages : inbox) {
      any = any || !next->empty();
      messages.insert(messages.end(), next->begin(), next->end());
      ++next;
    }
    return any;
  };
  for (Robot& robot : robots_) {
    take(robot.inbox);
    // Nobody reads them there.
    if (robot.failed || !robot.config.controller) {
      for (auto& messages : robot.inbox) messages.clear();
    }
  }
  for (Block& block : blocks_) {
    if (take(block.inbox)) block.quiet = false;
  }
  sends_ = false;
}

void Crew::say(std::uint64_t tick, const std::string& who, std::vector<std::string>& lines) {
  for (std::string& line : lines) log_.push_back({tick, who, std::move(line), false});
  lines.clear();
}

void Crew::fail(std::uint64_t tick, const std::string& who, const std::string& error) {
  log_.push_back({tick, who, error, true});
}

}  // namespace stig
