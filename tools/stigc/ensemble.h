// SPDX-License-Identifier: MIT
// Many runs of one config, run in batches so that memory does not grow with their
// number: what is kept of a run is a few numbers, unless more is asked for.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "explore_config.h"
#include "explore_outputs.h"
#include "uses.h"

namespace stig::cli {

struct RunSummary {
  std::uint64_t steps = 0, deposits = 0, bricks = 0, hash = 0;
  std::uint64_t enabled_left = 0, out_of_reach = 0;
  Terminated terminated = Terminated::saturated;
};

struct Ensemble {
  std::vector<RunSummary> runs;
  std::vector<std::uint64_t> fired;  ///< by rule, over all runs
  /// Structure hash (modulo translation) -> number of runs that ended there, those that
  /// were interrupted left out.
  std::map<std::uint64_t, std::uint64_t> structures;
  std::string runs_json;  ///< one JSON object a run, when asked for; parted by commas
  bool interrupted = false;
  int exit_code = 0;  ///< of the files written
};

/// Tables are written too, and a journal beside the first of them while it goes on.
Ensemble run_all(const RuleSet& rules, const RuleTable& table, const ExploreConfig& config,
                 const ExploreOptions& options, const std::vector<Output>& outputs, const App& app);

/// The lines for people.
std::string ensemble_lines(const RuleSet& rules, const ExploreConfig& config,
                           const Ensemble& ensemble, bool color);

}  // namespace stig::cli
