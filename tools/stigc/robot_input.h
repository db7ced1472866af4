// SPDX-License-Identifier: MIT
// The robot that a rule set is compiled for, and the blocks that it builds with.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "compiler/abilities.h"
#include "robots/block.h"
#include "robots/robot_model.h"
#include "uses.h"

namespace stig::cli {

/// The paper's, and the one that ARGoS has.
inline constexpr const char* kPaperRobot = "bebot.yaml";
inline constexpr const char* kArgosRobot = "builderbot.yaml";

/// One of our own robots. Errors are reported.
std::optional<RobotModel> read_own_robot(const char* name, const App& app);

/// Files of a robot and of the block that it builds with.
struct BuilderFiles {
  std::optional<std::string> robot, block;
  const char* usual = kPaperRobot;  ///< where no robot is given; the block is the paper's then
};
struct Builder {
  RobotModel robot;
  BlockModel block;
};

/// Reads both files; ours are found where scenes find theirs. Errors, and what keeps the robot from
/// building at all, are reported.
std::optional<Builder> read_builder(const BuilderFiles& files, const App& app);
/// What the compiler asks for of them.
std::optional<Abilities> read_abilities(const BuilderFiles& files, const App& app);

}  // namespace stig::cli
