// SPDX-License-Identifier: MIT
// A study: one command, done at every point of a grid of parameters, or at a sample of points.
//
// What an item is follows from the plan and the item's number alone, so that items can be done in
// any order, by whom ever, and any of them again. Parameters are options of the command, or values
// in the files that it reads, by their paths.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app.h"
#include "sweep_axis.h"
#include "uses.h"

namespace stig::cli {

struct SweepPlan {
  std::string path, name, command, file;
  /// Options that all items have.
  std::vector<std::pair<std::string, SweepValue>> options;
  std::vector<SweepAxis> axes;
  std::optional<std::uint64_t> sample;  ///< so many points at random; otherwise the whole grid
  std::uint64_t seed = 1;               ///< of the sample
  /// Files that items read, by the names that the plan has for them.
  std::map<std::string, std::string> texts;
  std::uint64_t hash = 0;  ///< of all that items depend on but the program's version
  std::uint64_t items = 0;
};

inline constexpr std::uint64_t kMostItems = 100'000'000;

/// Nothing where anything is wrong with the plan, which has been reported then.
std::optional<SweepPlan> read_sweep(const std::string& path, const App& app);
std::string sweep_schema();

/// The values at an item, one for each axis. The last axis is the first to change.
std::vector<SweepValue> point_of(const SweepPlan& plan, std::uint64_t item);

/// Which of a command's files a path is about: "rules.grow.probability" the rule set,
/// "robot.noise.x" the robot's; and the path in it.
struct PlaceInFile {
  std::string role;  ///< "file", or the option that names the file: "robot", "block", "scene"
  std::string path;
};
PlaceInFile place_of(std::string_view axis);

}  // namespace stig::cli
