// SPDX-License-Identifier: MIT
// Trials of many seeds on all cores; results in the order of seeds, the same for any number of
// threads.
#pragma once

#include <string>
#include <vector>

#include "app.h"
#include "base/diagnostic.h"
#include "physical/scene/scene.h"
#include "trial_journal.h"
#include "uses.h"
#include "validate/trial.h"

namespace stig::cli {

struct TrialBatch {
  std::vector<Trial> trials;            ///< of runs that could begin
  Diagnostics diagnostics;              ///< of those that could not
  std::vector<std::string> written;     ///< traces
  std::vector<std::string> complaints;  ///< of traces that could not be written
  bool journalled = true;               ///< all that are over are in the journal, if there is one
};

/// Traces go to the folder of `options` as run-SEED.stigp, when there is one. Pictures are drawn
/// only where they are wanted. Runs that an open journal has are not done again.
TrialBatch run_trials(const BuildTarget& target, const Scene& scene, const ValidateOptions& options,
                      double duration, bool pictures, TrialJournal& journal, const App& app);

}  // namespace stig::cli
