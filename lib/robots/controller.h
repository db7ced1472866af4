// SPDX-License-Identifier: MIT
// A robot's controller, whatever it is written in: Lua (lua_controller.h), or C++, which a
// ControllerFactory brings into a run (physical/scene/controller_factory.h).
//
// The loop calls init once, then step at every control tick, with readings taken just before;
// commands act from then on until others replace them. A controller that fails is not called
// again, its robot keeps its last commands' safe state (wheels and lift stopped, magnets off),
// and the reason is in the log.
#pragma once

#include <string>

#include "robots/robot_io.h"
#include "robots/uses.h"

namespace stig::robots {

struct ControllerStatus {
  bool ok = true;
  std::string error;  ///< with file and line where there are such
};

class RobotController {
 public:
  virtual ~RobotController() = default;
  virtual ControllerStatus init(RobotCommands& commands) = 0;
  virtual ControllerStatus step(const RobotReadings& readings, RobotCommands& commands) = 0;
  virtual void destroy() {}
};

class BlockController {
 public:
  virtual ~BlockController() = default;
  virtual ControllerStatus init(BlockCommands& commands) = 0;
  virtual ControllerStatus step(const BlockReadings& readings, BlockCommands& commands) = 0;
};

}  // namespace stig::robots
