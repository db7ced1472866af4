// SPDX-License-Identifier: MIT
#include "physical/scene/controller_factory.h"

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

std::unique_ptr<BlockController> block_program(const Scene& scene, const PlacedScene& placed,
                                               std::size_t body) {
  const std::size_t program = scene.block_programs[block_model(scene, placed, body)];
  if (program == RobotSpawn::kNoProgram) return nullptr;
  LuaSettings settings;
  settings.id = placed.bodies[body].name;
  settings.limits = block_limits();
  settings.seed = placed.seed;
  // Robots' streams begin at 0.
  settings.agent = static_cast<std::uint32_t>(scene.robots.size() + body);
  return std::make_unique<LuaBlockController>(scene.programs[program], settings);
}

}  // namespace

ControllerFactory lua_controllers() { return {robot_program, block_program}; }

}  // namespace stig
