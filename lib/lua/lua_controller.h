// SPDX-License-Identifier: MIT
// Controllers written in Lua: a state of its own for each robot and each block. What programs
// find is in docs/controllers.md; what holds them, in lua_box.h.
//
// After a failure a controller stays failed: every later call gives the same status.
#pragma once

#include <memory>

#include "lua/lua_settings.h"
#include "lua/uses.h"
#include "robots/controller.h"
#include "robots/robot_model.h"

namespace stig::lua {

class LuaController final : public RobotController {
 public:
  LuaController(LuaProgram program, RobotModel model, LuaSettings settings);
  ~LuaController() override;

  /// Loads and runs the program, then its init().
  ControllerStatus init(RobotCommands& commands) override;
  ControllerStatus step(const RobotReadings& readings, RobotCommands& commands) override;
  /// After init: is there a step() to call? Asked before a run; steps ask for themselves.
  ControllerStatus ready();
  /// What ended the call that failed, and where.
  const LuaFailure& failure() const;
  /// The program's reset(), when the experiment begins anew.
  ControllerStatus reset(RobotCommands& commands);
  /// The program's destroy(); what it commands is not carried out.
  void destroy() override;

  /// Bytes that the state holds.
  std::size_t memory() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class LuaBlockController final : public BlockController {
 public:
  LuaBlockController(LuaProgram program, LuaSettings settings);
  ~LuaBlockController() override;

  ControllerStatus init(BlockCommands& commands) override;
  ControllerStatus step(const BlockReadings& readings, BlockCommands& commands) override;
  ControllerStatus ready();
  const LuaFailure& failure() const;

  std::size_t memory() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stig::lua
