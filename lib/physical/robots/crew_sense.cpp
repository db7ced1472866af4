// SPDX-License-Identifier: MIT
// What the robots of a crew perceive.
#include "physical/robots/crew.h"
#include "physical/sensors/camera_reading.h"
#include "physical/sensors/range_sensor.h"

namespace stig {

namespace {

Rgb light_of(Led led) { return led == Led::off ? Rgb{} : rgb_of(led); }

}  // namespace

void Crew::place(SensorScene& scene, const World& world) const {
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    scene.obstacles[i].X_WS = world.state(BodyId{obstacle_bodies_[i]}).X_WB;
  }
  scene.marked.resize(blocks_.size());
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    MarkedBody& marked = scene.marked[i];
    marked.owner = static_cast<std::uint32_t>(i);
    marked.kind = static_cast<std::uint32_t>(blocks_[i].config.model);
    marked.X_WB = world.state(blocks_[i].config.body).X_WB;
    marked.leds.clear();
    if (!config_.lights) continue;
    for (const Led led : blocks_[i].leds) marked.leds.push_back(light_of(led));
  }
}

SensorScene Crew::sensor_scene(const World& world) const {
  SensorScene out = scene_;
  place(out, world);
  return out;
}

Pose Crew::camera_pose(const World& world, std::size_t robot, std::size_t camera) const {
  const CameraDevice& device = model(robot).cameras[camera];
  return pose_of(world, robots_[robot].config.body, device.body) * device.X_BC;
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
    if (robot.enabled[i]) continue;
    // Pictures that were on their way when it was switched off are lost.
    out.cameras[i].enabled = false;
    out.cameras[i].tags.clear();
    out.cameras[i].leds.clear();
  }
  out.rangefinders =
      robot.late_ranges[0].pass(feel(world, index, number), robot.config.range_noise.latency);
  // Nothing has arrived yet: as if nothing were in reach.
  for (std::size_t i = out.rangefinders.size(); i < model.rangefinders.size(); ++i) {
    out.rangefinders.push_back({without_hit(model.rangefinders[i]), 0});
  }
  out.radios = std::exchange(robot.inbox, std::vector<std::vector<Message>>(model.radios.size()));
  read(world, model, robot.config.body, robot.devices, out);
}

CameraReading Crew::see(const World& world, const SensorIndex& index, std::size_t number,
                        std::size_t camera) {
  const Robot& robot = robots_[number];
  const Pose X_WC = camera_pose(world, number, camera);
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
    const std::uint32_t owner = crew_owner(number);
    out.push_back({read_range(index, device, pose_of(world, robot.config.body, device.body), owner,
                              robot.config.range_noise, address),
                   0});
  }
  return out;
}

}  // namespace stig
