// SPDX-License-Identifier: MIT
// The folder that a validation writes: names in it are fixed, so that a validation can be repeated
// into it, and it is known again by its report.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app.h"
#include "uses.h"

namespace stig::cli {

inline constexpr const char* kSceneFile = "scene.yaml";
inline constexpr const char* kReport = "report.json";
inline constexpr std::array kReportFiles = {"progress.csv", "progress.svg", kReport, "report.html"};
/// What the scene calls the user's robot.
inline constexpr const char* kGivenRobot = "robot.yaml";

/// The name that a run's trace has in the folder.
std::string trace_name(std::uint64_t seed);

/// Every file that is written into the folder: those of the scene, those of the report, and a trace
/// for each of `runs` seeds from `seed` on.
std::vector<std::string> validation_files(std::vector<std::string> scene_files, std::uint64_t seed,
                                          int runs);

/// As prepare_folder does, which refuses where such files are there and no validation wrote them.
int prepare_validation(const std::string& folder, const std::vector<std::string>& files,
                       const App& app);

/// Traces in the folder of other runs than those in `files`, in order of their names: an earlier
/// validation left them, and the report does not speak of them.
std::vector<std::string> other_traces(const std::string& folder,
                                      const std::vector<std::string>& files);

}  // namespace stig::cli
