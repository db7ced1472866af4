// SPDX-License-Identifier: MIT
// Two functions of lua_programs.h as they are: null for who has no program.
#include "physical/scene/controller_factory.h"

#include "physical/scene/lua_programs.h"

namespace stig::physics {

ControllerFactory lua_controllers() { return {robot_program, block_program}; }

}  // namespace stig::physics
