// SPDX-License-Identifier: MIT
// A scene's programs in Lua, as they are when a run begins: each with its own name, parameters and
// stream of random numbers.
#pragma once

#include <memory>
#include <optional>

#include "lua/lua_controller.h"
#include "lua/lua_script.h"
#include "physical/scene/scene.h"
#include "physical/scene/uses.h"

namespace stig::physics {

/// The program of the scene's robot of that number; null when it has none.
std::unique_ptr<LuaController> robot_program(const Scene& scene, const PlacedScene& placed,
                                             std::size_t robot);
/// The program of the block that is that body; null when it has none.
std::unique_ptr<LuaBlockController> block_program(const Scene& scene, const PlacedScene& placed,
                                                  std::size_t body);
/// The experiment's script, if there is one.
std::optional<LuaScript> script_of(const Scene& scene, const PlacedScene& placed);

}  // namespace stig::physics
