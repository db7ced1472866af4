// SPDX-License-Identifier: MIT
// The robots of a scene that build, and the sides that their parameters bind them to.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/approach.h"
#include "physical/scene/scene.h"
#include "validate/uses.h"

namespace stig::validate {

/// Does it run the compiled program? Robots with others may stand about.
bool is_builder(const Scene& scene, const RobotSpawn& robot);

/// A parameter of its program, or null.
const LuaValue* param_of(const RobotSpawn& robot, std::string_view name);

/// "+x -y": the sides, words parted by blanks. Nothing where there is none, or one is no side.
std::optional<std::vector<ApproachSide>> sides_in(const LuaValue& value);

}  // namespace stig::validate
