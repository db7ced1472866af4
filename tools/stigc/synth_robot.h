// SPDX-License-Identifier: MIT
// stigc synth --robot: from a target to rules that a robot can follow.
#pragma once

#include "app.h"
#include "assembly/remedies.h"
#include "uses.h"

namespace stig::cli {

/// Options that do not go together are a usage error.
int synth_for_robot(const SynthOptions& options, App& app);

/// What came of it, for people: sides, robots, the order drawn.
std::string plan_lines(const Target& target, const Assembly& made);
/// Why nothing did.
std::string obstacle_lines(const Target& target, const AssemblyObstacle& obstacle, bool color);
/// What was tried and helps.
std::string remedy_lines(const std::vector<AssemblyRemedy>& remedies);
/// "none of 60 candidates: 12 had no order, …".
std::string counts_in_words(const AssemblyCounts& counts);
/// All of it as one JSON object. `cut_short`: of the search, or of what would help.
std::string assembly_json(const SynthOptions& options, const Target& target, const Assembly& made,
                          const std::vector<AssemblyRemedy>& remedies, bool cut_short,
                          double seconds, const std::vector<std::string>& written);

}  // namespace stig::cli
