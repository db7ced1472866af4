// SPDX-License-Identifier: MIT
// From what the command line asks of explore to the config of a run, defaults filled
// in, and what is wrong with it in words.
#pragma once

#include <string>

#include "lattice/swarm.h"
#include "options.h"
#include "uses.h"

namespace stig::cli {

inline constexpr std::uint64_t kDefaultSteps = 10'000'000;
inline constexpr std::uint64_t kDefaultDeposits = 100'000;

struct ExploreConfig {
  SwarmConfig swarm;
  bool steps_by_default = false;     ///< max_steps was not asked for
  bool deposits_by_default = false;  ///< max_deposits was not asked for
  std::string problem;               ///< empty: none
};

ExploreConfig explore_config(const RuleSet& rules, const RuleTable& table,
                             const ExploreOptions& options);

}  // namespace stig::cli
