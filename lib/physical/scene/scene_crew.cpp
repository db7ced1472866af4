// SPDX-License-Identifier: MIT
#include "physical/scene/scene_crew.h"

#include "lua/lua_controller.h"

namespace stig {

namespace {

std::unique_ptr<RobotController> robot_program(const Scene& scene, const PlacedScene& placed,
                                               std::size_t robot) {
  const RobotSpawn& spawn = scene.robots[robot];
  if (spawn.program == RobotSpawn::kNoProgram) return nullptr;
  LuaSettings settings;
  settings.id = spawn.name;
  settings.params = spawn.params;
  settings.seed = placed.seed;
  settings.agent = static_cast<std::uint32_t>(robot);
  return std::make_unique<LuaController>(scene.programs[spawn.program],
                                         scene.robot_models[spawn.model], settings);
}

}  // namespace

CrewBlock crew_block(const Scene& scene, const PlacedScene& placed, std::size_t body) {
  CrewBlock out;
  out.name = placed.bodies[body].name;
  out.body = BodyId{static_cast<std::uint32_t>(body)};
  out.led = placed.bodies[body].colour;
  // What a cache drops has no entry of its own.
  out.model = body < placed.config.bodies.size() ? scene.blocks[placed.bodies[body].entry].model
                                                 : scene.stock_model;
  const std::size_t program = scene.block_programs[out.model];
  if (program == RobotSpawn::kNoProgram) return out;
  LuaSettings settings;
  settings.id = out.name;
  settings.limits = block_limits();
  settings.seed = placed.seed;
  // Robots' streams begin at 0.
  settings.agent = static_cast<std::uint32_t>(scene.robots.size() + body);
  out.controller = std::make_unique<LuaBlockController>(scene.programs[program], settings);
  return out;
}

CrewConfig crew_of(const Scene& scene, const PlacedScene& placed) {
  CrewConfig out;
  out.seed = placed.seed;
  out.lights = scene.lights;
  out.models = scene.models;
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    CrewRobot robot;
    robot.name = scene.robots[i].name;
    robot.model = &scene.robot_models[scene.robots[i].model];
    robot.body = placed.robots[i];
    robot.controller = robot_program(scene, placed, i);
    robot.camera_noise = scene.camera_noise;
    robot.range_noise = scene.range_noise;
    out.robots.push_back(std::move(robot));
  }
  for (std::size_t i = 0; i < placed.config.bodies.size(); ++i) {
    if (placed.bodies[i].block) out.blocks.push_back(crew_block(scene, placed, i));
  }
  return out;
}

}  // namespace stig
