// SPDX-License-Identifier: MIT
// One snapshot of the world a tick, shared by all sensors: shapes and owners are set up once, poses
// are filled in before each look. Rangefinders must not measure their own robot, nor may a tag be
// hidden by its own block, so every obstacle has an owner.
#include "physical/robots/crew_senses.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "physical/sensors/camera_reading.h"
#include "physical/sensors/range_sensor.h"

namespace stig::physics {

namespace {

// Owners of obstacles: blocks' are their numbers, robots' these, and loose bodies have none.
constexpr std::uint32_t kNobody = 0xffffffff;
std::uint32_t robot_owner(std::size_t robot) {
  return kNobody - 1 - static_cast<std::uint32_t>(robot);
}

Rgb light_of(Led led) { return led == Led::off ? Rgb{} : rgb_of(led); }

/// The place of a shape among the scene's; a new one is added. Blocks are mostly of one shape,
/// which thousands of obstacles share.
std::uint32_t place_among(std::vector<SightShape>& shapes, SightShape shape) {
  const auto found = std::find(shapes.begin(), shapes.end(), shape);
  const auto place = static_cast<std::uint32_t>(found - shapes.begin());
  if (found == shapes.end()) shapes.push_back(std::move(shape));
  return place;
}

/// How the bodies of a world look: as they touch, but for wheels, which touch as balls.
std::vector<SightShape> sights_of(const CrewConfig& config, const WorldConfig& world) {
  std::vector<SightShape> out;
  for (const BodyDef& body : world.bodies) out.push_back(sight_of(body.shape));
  for (const CrewRobot& robot : config.robots) {
    for (std::size_t i = 0; i < robot.model->bodies.size(); ++i) {
      const BodyModel& body = robot.model->bodies[i];
      if (!body.rolls_as_sphere) continue;
      out[static_cast<std::size_t>(robot.body.bodies[i])] =
          sight_cylinder(body.size.x / 2, body.size.z);
    }
  }
  return out;
}

RobotSenses senses_of(const RobotModel& model) {
  RobotSenses out;
  for (const CameraDevice& camera : model.cameras) {
    const auto view = make_view(camera.intrinsics, camera.near, camera.far);
    assert(view);  // the reader has refused cameras that make no sense
    out.views.push_back(*view);
  }
  out.enabled.assign(model.cameras.size(), false);
  out.late_cameras.resize(model.cameras.size());
  // All rangefinders are read together, and so are late together.
  out.late_ranges.resize(1);
  return out;
}

NoiseAddress address_of(const CrewConfig& config, std::size_t robot, std::size_t device,
                        const World& world) {
  return {config.seed, static_cast<std::uint32_t>(robot), static_cast<std::uint32_t>(device),
          world.tick()};
}

/// What the body sensors of a kind read.
template <BodySensor Kind>
void sense_bodies(const CrewConfig& config, const World& world, std::size_t number,
                  RobotReadings& out) {
  const CrewRobot& robot = config.robots[number];
  auto& readings = Kind::readings(out);
  readings.clear();
  for (const typename Kind::Device& device : Kind::devices(*robot.model)) {
    const BodyState body = world.state(robot.body.bodies[device.body]);
    const std::size_t place = first_number<Kind>(*robot.model) + readings.size();
    Random random = noise_stream(address_of(config, number, place, world));
    readings.push_back(Kind::sense(device, {body.X_WB, body.velocity, body.spin}, random));
  }
}

/// Whether no more is on its way than can be.
template <class Queues>
bool all_in_time(const Queues& queues, int latency) {
  return std::all_of(queues.begin(), queues.end(), [latency](const auto& queue) {
    return queue.on_the_way.size() <= static_cast<std::size_t>(latency);
  });
}

}  // namespace

CrewSenses::CrewSenses(const CrewConfig& config, const WorldConfig& world) {
  scene_.floor = world.floor;
  for (const BlockModel& model : config.models) {
    scene_.kinds.push_back(cube_marks({model.side, model.tags.side, model.tags.proud,
                                       model.leds.offset, model.tags.widest, model.leds.widest}));
  }
  // Bodies that belong to neither block nor robot are obstacles that nobody owns.
  std::vector<std::uint32_t> owners(world.bodies.size(), kNobody);
  for (std::size_t i = 0; i < config.blocks.size(); ++i) {
    owners[static_cast<std::size_t>(config.blocks[i].body)] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t i = 0; i < config.robots.size(); ++i) {
    for (const BodyId body : config.robots[i].body.bodies) {
      owners[static_cast<std::size_t>(body)] = robot_owner(i);
    }
  }
  std::vector<SightShape> sights = sights_of(config, world);
  for (std::uint32_t i = 0; i < world.bodies.size(); ++i) {
    add_obstacle(BodyId{i}, std::move(sights[i]), owners[i]);
  }
  for (const CrewRobot& robot : config.robots) robots_.push_back(senses_of(*robot.model));
}

void CrewSenses::add_obstacle(BodyId body, SightShape shape, std::uint32_t owner) {
  scene_.obstacles.push_back({place_among(scene_.shapes, std::move(shape)), owner, {}});
  obstacle_bodies_.push_back(body);
}

void CrewSenses::add_block(std::size_t number, const CrewBlock& block, const Shape& shape) {
  add_obstacle(block.body, sight_of(shape), static_cast<std::uint32_t>(number));
}

void CrewSenses::place(SensorScene& scene, const CrewConfig& config, const World& world,
                       const CrewSignals& signals) const {
  // Bodies that have left keep their last pose, outside of the arena.
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    scene.obstacles[i].X_WS = world.state(obstacle_bodies_[i]).X_WB;
  }
  scene.marked.resize(config.blocks.size());
  for (std::size_t i = 0; i < config.blocks.size(); ++i) {
    MarkedBody& marked = scene.marked[i];
    marked.owner = static_cast<std::uint32_t>(i);
    marked.kind = static_cast<std::uint32_t>(config.blocks[i].model);
    marked.X_WB = world.state(config.blocks[i].body).X_WB;
    marked.leds.clear();
    // In a scene without lights no LED shines, whatever blocks command.
    if (!config.lights) continue;
    for (const Led led : signals.leds(i)) marked.leds.push_back(light_of(led));
  }
}

SensorIndex CrewSenses::look(const CrewConfig& config, const World& world,
                             const CrewSignals& signals) {
  place(scene_, config, world, signals);
  return SensorIndex(scene_);
}

SensorScene CrewSenses::scene(const CrewConfig& config, const World& world,
                              const CrewSignals& signals) const {
  SensorScene out = scene_;
  place(out, config, world, signals);
  return out;
}

void CrewSenses::sense(const CrewConfig& config, const World& world, const SensorIndex& index,
                       std::size_t number, RobotReadings& out) {
  const CrewRobot& robot = config.robots[number];
  const RobotModel& model = *robot.model;
  RobotSenses& senses = robots_[number];
  out.cameras.resize(model.cameras.size());
  for (std::size_t i = 0; i < model.cameras.size(); ++i) {
    // A reading is handed out `latency` ticks after it was taken.
    out.cameras[i] = senses.late_cameras[i].pass(see(config, world, index, number, i),
                                                 robot.camera_noise.latency);
    if (senses.enabled[i]) continue;
    // Pictures that were on their way when it was switched off are lost.
    out.cameras[i].enabled = false;
    out.cameras[i].tags.clear();
    out.cameras[i].leds.clear();
  }
  out.rangefinders =
      senses.late_ranges[0].pass(feel(config, world, index, number), robot.range_noise.latency);
  // In the first ticks, while readings are late, nothing has arrived yet: as if nothing were in
  // reach.
  for (std::size_t i = out.rangefinders.size(); i < model.rangefinders.size(); ++i) {
    out.rangefinders.push_back(reading_before<RangefinderKind>(model.rangefinders[i]));
  }
  DeviceKinds::each([&](auto kind) {
    using Kind = decltype(kind);
    if constexpr (BodySensor<Kind>) sense_bodies<Kind>(config, world, number, out);
  });
}

CameraReading CrewSenses::see(const CrewConfig& config, const World& world,
                              const SensorIndex& index, std::size_t number,
                              std::size_t camera) const {
  const CrewRobot& robot = config.robots[number];
  const RobotSenses& senses = robots_[number];
  const Pose X_WC = camera_pose(world, robot, camera);
  CameraReading out;
  if (senses.enabled[camera] && !senses.dark) {
    // Addressed noise: what one sensor draws does not depend on what others do.
    const std::size_t place = first_number<CameraKind>(*robot.model) + camera;
    const NoiseAddress address = address_of(config, number, place, world);
    const CameraView& view = senses.views[camera];
    out = read_camera(scene_, physics::look(index, view, X_WC), view, robot.camera_noise, address);
  }
  out.enabled = senses.enabled[camera];
  out.timestamp = world.time();
  // Where the camera stands, for cameras that ride on a lift; robots know their own joints.
  out.X_RC = inverse(pose_of(world, *robot.model, robot.body)) * X_WC;
  return out;
}

std::vector<RangeReading> CrewSenses::feel(const CrewConfig& config, const World& world,
                                           const SensorIndex& index, std::size_t number) const {
  const CrewRobot& robot = config.robots[number];
  const RobotModel& model = *robot.model;
  std::vector<RangeReading> out;
  for (std::size_t i = 0; i < model.rangefinders.size(); ++i) {
    const RangeDevice& device = model.rangefinders[i];
    const std::size_t place = first_number<RangefinderKind>(model) + i;
    const NoiseAddress address = address_of(config, number, place, world);
    out.push_back({read_range(index, device, pose_of(world, robot.body, device.body),
                              robot_owner(number), robot.range_noise, address),
                   0});
  }
  return out;
}

void CrewSenses::obey(std::size_t robot, const RobotCommands& commands) {
  std::vector<bool>& enabled = robots_[robot].enabled;
  for (std::size_t i = 0; i < commands.camera_enabled.size(); ++i) {
    if (commands.camera_enabled[i]) enabled[i] = *commands.camera_enabled[i];
  }
}

// For checkpoints, whose bytes are untrusted.
bool CrewSenses::fits(const CrewConfig& config) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const CrewRobot& robot = config.robots[i];
    const RobotSenses& senses = robots_[i];
    if (senses.enabled.size() != robot.model->cameras.size() ||
        !all_in_time(senses.late_cameras, robot.camera_noise.latency) ||
        !all_in_time(senses.late_ranges, robot.range_noise.latency)) {
      return false;
    }
  }
  return true;
}

void count_wheels(const CrewConfig& config, const World& world, std::size_t number,
                  RobotReadings& readings) {
  const EncoderNoise& noise = config.robots[number].encoder_noise;
  Random random = noise_stream(address_of(config, number, kDriveDevice, world));
  readings.left_encoder = counted(readings.left_encoder, noise, random);
  readings.right_encoder = counted(readings.right_encoder, noise, random);
}

Pose camera_pose(const World& world, const CrewRobot& robot, std::size_t camera) {
  assert(camera < robot.model->cameras.size());
  const CameraDevice& device = robot.model->cameras[camera];
  return pose_of(world, robot.body, device.body) * device.X_BC;
}

}  // namespace stig::physics
