// SPDX-License-Identifier: MIT
// Programs run under limits and with random streams of their own. What tells the streams of one run
// apart is an agent's number: robots from 0, then blocks by their bodies, and the script at the
// end.
#include "physical/scene/lua_programs.h"

#include <cassert>

namespace stig::physics {

namespace {

constexpr std::uint32_t kScriptAgent = 0xffffff;  ///< beyond all robots and blocks

}  // namespace

std::unique_ptr<LuaController> robot_program(const Scene& scene, const PlacedScene& placed,
                                             std::size_t robot) {
  assert(robot < scene.robots.size());
  const RobotSpawn& spawn = scene.robots[robot];
  // A robot without a program stands where it is.
  if (spawn.program == RobotSpawn::kNoProgram) return nullptr;
  LuaSettings settings;
  settings.id = spawn.name;
  settings.params = spawn.params;
  settings.seed = placed.seed;
  settings.agent = static_cast<std::uint32_t>(robot);
  return std::make_unique<LuaController>(scene.programs[spawn.program],
                                         scene.robot_models[spawn.model], settings);
}

std::unique_ptr<LuaBlockController> block_program(const Scene& scene, const PlacedScene& placed,
                                                  std::size_t body) {
  assert(body < placed.bodies.size() && placed.bodies[body].block);
  const std::size_t program = scene.block_programs[block_model(scene, placed, body)];
  if (program == RobotSpawn::kNoProgram) return nullptr;
  LuaSettings settings;
  settings.id = placed.bodies[body].name;
  // Thousands of blocks fit into memory only with small states.
  settings.limits = block_limits();
  settings.seed = placed.seed;
  // Robots' streams begin at 0.
  settings.agent = static_cast<std::uint32_t>(scene.robots.size() + body);
  return std::make_unique<LuaBlockController>(scene.programs[program], settings);
}

std::optional<LuaScript> script_of(const Scene& scene, const PlacedScene& placed) {
  if (scene.script == RobotSpawn::kNoProgram) return std::nullopt;
  LuaSettings settings;
  settings.id = "script";
  // A script looks at all blocks in one call.
  settings.limits.instructions *= 10;
  settings.seed = placed.seed;
  settings.agent = kScriptAgent;
  return LuaScript(scene.programs[scene.script], settings);
}

}  // namespace stig::physics
