// SPDX-License-Identifier: MIT
// Robot files (robots/*.yaml) as robots. Every problem is found at once: keys and values by the
// table of keys, names, joints and devices here.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostic.h"
#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

inline constexpr std::size_t kMaxRobotFileBytes = std::size_t{1} << 20;

/// The robot, or nothing when an error was reported. Files that it names are looked for by `load`,
/// without one beside the robot's.
std::optional<RobotModel> read_robot(SourceRef source, Diagnostics& diagnostics,
                                     const FileLoader& load = {});
/// Reads the file first; a file that cannot be read is a diagnostic too.
std::optional<RobotModel> read_robot_file(const std::string& path, Diagnostics& diagnostics);

/// JSON Schema of robot files.
std::string robot_schema();

}  // namespace stig::robots
