// SPDX-License-Identifier: MIT
// A swarm that runs on its rules while somebody looks at it.
#pragma once

#include <memory>

#include "lattice/swarm.h"
#include "live/live_run.h"

namespace stig::live {

/// The config must have no problem. News: [x, y, z, colour, rule, agent, step] of each brick. A
/// checkpoint is the trace so far.
std::unique_ptr<LiveRun> lattice_live(RuleSet rules, const SwarmConfig& config, std::string name);

}  // namespace stig::live
