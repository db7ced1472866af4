// SPDX-License-Identifier: MIT
// What a simulated run came to, as data, JSON and lines for people.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "physical/readout/lattice_reading.h"
#include "physical/render/scene_picture.h"
#include "physical/simulation/simulation.h"
#include "uses.h"

namespace stig::cli {

using Json = nlohmann::ordered_json;

struct SimulationReport {
  std::string title;
  std::uint64_t seed = 1, ticks = 0, hash = 0;
  double time = 0;     ///< s, simulated
  double seconds = 0;  ///< that it took
  RunEnd end = RunEnd::duration;
  std::string message;
  std::size_t bodies = 0, awake = 0, fixed = 0;
  std::size_t moved = 0;  ///< bodies more than kMovedFrom from where they began
  double farthest = 0;    ///< m, of one that is still there
  std::string farthest_name;
  RunTally tally;
  std::vector<std::string> left;  ///< names
  StructureReading structure;
  std::vector<ScriptRobot> robots;
  std::map<std::string, double> measures;
  bool script_failed = false;
  bool programs_failed = false;            ///< every one: nothing was controlled in the end
  std::vector<std::string> failed_blocks;  ///< whose programs failed
  std::vector<std::string> names;          ///< of blocks that are there
};

inline constexpr double kMovedFrom = 1e-3;  ///< m

/// What is said of a run whose `programs_failed`.
inline constexpr std::string_view kProgramsFailed = "every program failed";

SimulationReport report_of(const Scene& scene, const Simulation& run, RunEnd end, double seconds);

Json to_json(const SimulationReport& report);
/// With the line on speed, which differs from call to call, when `speed`.
std::string lines_of(const SimulationReport& report, bool speed);

/// The lattices that blocks make, one line each, and what is loose.
std::string structure_in_lines(const StructureReading& structure);
Json structure_json(const StructureReading& structure, const std::vector<std::string>& names);

/// A table of runs, and what they have in common.
std::string table_of(const std::vector<SimulationReport>& runs);

/// The lattices of the blocks among them.
StructureReading structure_of(const std::vector<PictureBody>& bodies);

/// What is written below a picture; a grid of 0 m: none.
std::string picture_caption(const std::string& title, double time, double grid);
/// Draws and writes; false with `error` set.
bool write_picture(const std::string& path, const std::vector<PictureBody>& bodies,
                   const std::vector<PictureLine>& lines, bool floor, const std::string& title,
                   double time, std::string& error);

}  // namespace stig::cli
