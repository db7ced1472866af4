// SPDX-License-Identifier: MIT
// Who makes the controllers of a scene's robots and blocks: programs in Lua, unless a caller has
// others, in C++ or any language that it brings.
//
//     ControllerFactory factory = lua_controllers();
//     factory.robot = [](const Scene& scene, const PlacedScene&, std::size_t robot) {
//       return std::make_unique<Approach>(scene.robot_models[scene.robots[robot].model]);
//     };
//     Simulation run(scene, placed, true, factory);
//
// A run makes its controllers anew when it is brought back from a checkpoint, and feeds them what
// those before them have read. So a controller must depend on its readings, the scene and the
// seed alone; then it comes to the state that it was in.
#pragma once

#include <functional>
#include <memory>

#include "physical/scene/scene.h"
#include "physical/scene/uses.h"
#include "robots/controller.h"

namespace stig::physics {

/// Either function may give null: a robot without controller stands where it is, a block without
/// one keeps its LEDs as they are.
struct ControllerFactory {
  /// Makes the controller of the scene's robot of that number.
  std::function<std::unique_ptr<RobotController>(const Scene& scene, const PlacedScene& placed,
                                                 std::size_t robot)>
      robot;
  /// Makes the controller of the block that is that body, which may come while the scene runs.
  std::function<std::unique_ptr<BlockController>(const Scene& scene, const PlacedScene& placed,
                                                 std::size_t body)>
      block;
};

/// The programs that the scene names.
ControllerFactory lua_controllers();

}  // namespace stig::physics
