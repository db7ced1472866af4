// SPDX-License-Identifier: MIT
// The crew is what acts in a world: it takes the scene's robots and blocks with what their
// controllers, sensors and radios need, and points into the scene, which outlives it.
#include "physical/scene/scene_crew.h"

#include <cassert>

namespace stig::physics {

CrewBlock crew_block(const Scene& scene, const PlacedScene& placed, std::size_t body,
                     const ControllerFactory& controllers) {
  assert(body < placed.bodies.size());
  CrewBlock out;
  out.name = placed.bodies[body].name;
  out.body = BodyId{static_cast<std::uint32_t>(body)};
  // The colour of the scene's file is what a block shows before its program says otherwise.
  out.led = placed.bodies[body].colour;
  out.model = block_model(scene, placed, body);
  if (controllers.block) out.controller = controllers.block(scene, placed, body);
  return out;
}

CrewConfig crew_of(const Scene& scene, const PlacedScene& placed,
                   const ControllerFactory& controllers) {
  assert(placed.robots.size() == scene.robots.size());
  CrewConfig out;
  out.seed = placed.seed;
  out.lights = scene.lights;
  out.models = scene.models;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    CrewRobot robot;
    robot.name = scene.robots[i].name;
    robot.model = &scene.robot_models[scene.robots[i].model];
    robot.body = placed.robots[i];
    if (controllers.robot) robot.controller = controllers.robot(scene, placed, i);
    robot.camera_noise = scene.camera_noise;
    robot.range_noise = scene.range_noise;
    robot.encoder_noise = scene.encoder_noise;
    out.robots.push_back(std::move(robot));
  }
  for (std::size_t i = 0; i < placed.config.bodies.size(); ++i) {
    if (placed.bodies[i].block) out.blocks.push_back(crew_block(scene, placed, i, controllers));
  }
  return out;
}

}  // namespace stig::physics
