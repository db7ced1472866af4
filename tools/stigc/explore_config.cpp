// SPDX-License-Identifier: MIT
// What the command line leaves open is chosen here, and remembered as chosen, so that a limit
// nobody asked for can be told of when it ends a run.
#include "explore_config.h"

#include "meant_box.h"

namespace stig::cli {
namespace {

std::optional<Box> chosen_box(const RuleSet& rules, const ExploreOptions& options,
                              std::string& problem) {
  constexpr Offset kDefaultSize{20, 20, 20};
  const WorldOptions& world = options.world;
  std::string unbounded;
  std::optional<BoxSpec> spec = meant_box(rules, world, unbounded);
  // Agents need a box and get one; events may grow freely and need none.
  const bool wanted = options.motion != Motion::event || world.periodic || world.origin;
  if (!spec && !world.box && wanted) spec = BoxSpec{kDefaultSize, world.origin, world.periodic};
  if (spec) return lay_box(*spec, rules.start, rules.floor);
  if (options.motion != Motion::event) {
    problem = "agents need a box: --box none is for event motion";
  }
  if (!unbounded.empty()) problem = unbounded;
  return std::nullopt;
}

void set_limits(const ExploreOptions& options, ExploreConfig& config) {
  config.swarm.max_steps = options.steps;
  config.swarm.max_deposits = options.deposits;
  // Where one limit is given, no other is added.
  if (options.steps || options.deposits) return;
  if (options.motion != Motion::event) {
    config.swarm.max_steps = kDefaultSteps;
    config.steps_by_default = true;
  } else if (!config.swarm.box) {
    // In a box events end by themselves; in unbounded space they need not.
    config.swarm.max_deposits = kDefaultDeposits;
    config.deposits_by_default = true;
  }
}

std::string event_problem(const ExploreOptions& options) {
  if (options.motion != Motion::event) return {};
  if (options.agents || !options.agents_at.empty()) return "event motion has no agents";
  if (options.moves) return "event motion has no moves";
  return {};
}

}  // namespace

ExploreConfig explore_config(const RuleSet& rules, const RuleTable& table,
                             const ExploreOptions& options) {
  constexpr int kDefaultAgents = 10;
  ExploreConfig config;
  config.problem = event_problem(options);
  config.swarm.motion = options.motion;
  config.swarm.box = chosen_box(rules, options, config.problem);
  const auto placed = static_cast<int>(options.agents_at.size());
  // Naming places for agents asks for as many.
  config.swarm.agents = options.agents.value_or(std::max(kDefaultAgents, placed));
  config.swarm.moves = options.moves.value_or(neighbourhood(rules.lattice).size);
  config.swarm.agents_at = options.agents_at;
  config.swarm.seed = options.seed;
  set_limits(options, config);
  if (config.problem.empty()) config.problem = config_problem(table, rules.start, config.swarm);
  return config;
}

}  // namespace stig::cli
