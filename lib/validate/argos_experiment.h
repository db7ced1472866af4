// SPDX-License-Identifier: MIT
// The same set-up as an experiment file of ARGoS 3: its BuilderBot, its block, dynamics3d, media.
//
// What ARGoS has no plugin for is a cache that fills itself again; so every block that the
// structure takes lies there from the beginning, and one more for each side: behind each cache's
// place, and so far apart that a robot fits between them.
#pragma once

#include <string>

#include "validate/set_up.h"
#include "validate/uses.h"

namespace stig::validate {

inline constexpr double kBlocksApart = 0.3;  ///< m, centre to centre

/// Names of the programs' files, as the experiment's own folder has them; valid UTF-8 without
/// control characters.
struct ArgosScripts {
  std::string robot, block;
};

/// XML; `request.robot_file` is not asked.
std::string argos_experiment(const RuleSet& rules, const CompiledRules& compiled,
                             const SetUpRequest& request, const ArgosScripts& scripts);

}  // namespace stig::validate
