// SPDX-License-Identifier: MIT
// The robot that a rule set is compiled for, and the blocks that it builds with.
#pragma once

#include <optional>
#include <string>

#include "app.h"
#include "compiler/abilities.h"
#include "uses.h"

namespace stig::cli {

/// The paper's, and the one that ARGoS has.
inline constexpr const char* kPaperRobot = "bebot.yaml";
inline constexpr const char* kArgosRobot = "builderbot.yaml";

/// One of our own robots. Errors are reported.
std::optional<RobotModel> read_own_robot(const char* name, const App& app);

/// Reads a robot's file, by default one of ours, with the paper's block: both are found
/// where scenes find theirs. Errors, and what keeps it from building at all, are reported.
std::optional<Abilities> read_abilities(const std::optional<std::string>& robot_file,
                                        const App& app, const char* usual = kPaperRobot);

}  // namespace stig::cli
