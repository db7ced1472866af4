// SPDX-License-Identifier: MIT
// Agent-steps per second of the walk engine around a finished nest of architecture-4n,
// with and without vector instructions, beside the baseline in the same run, and of teleport
// motion, which does not make most of its jumps. A brick far from the nest keeps one site
// enabled, and rules fire too rarely to matter, so that no run saturates and all do the same
// number of steps.
#include <benchmark/benchmark.h>

#include <vector>

#include "baseline_walk.h"
#include "lattice/swarm.h"
#include "shipped.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

constexpr std::uint64_t kAgentSteps = 20'000'000;

/// The rules with a finished nest as their start.
RuleSet around_a_nest() {
  RuleSet rules = shipped("architecture-4n");
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = lay_box(*rules.box, rules.start, rules.floor);
  const Structure nest = run_swarm(RuleTable(rules), rules.start, config).structure;
  rules.start = to_origin(nest).bricks();
  rules.start.push_back({rules.start.front().at - Offset{3, 0, 0}, 1});
  for (Rule& rule : rules.rules) {
    rule.stage = 0;
    rule.probability = 1e-12;
  }
  return rules;
}

SwarmConfig config_for(const RuleSet& rules, int side, int agents) {
  SwarmConfig config;
  config.box = lay_box({{side, side, side}, std::nullopt, false}, rules.start, rules.floor);
  config.agents = agents;
  config.max_steps = kAgentSteps / static_cast<std::uint64_t>(agents);
  return config;
}

void report(benchmark::State& state) {
  state.counters["agent_steps/s"] =
      benchmark::Counter(static_cast<double>(kAgentSteps) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

void baseline(benchmark::State& state) {
  const RuleSet rules = around_a_nest();
  const auto side = static_cast<int>(state.range(0)), agents = static_cast<int>(state.range(1));
  const SwarmConfig config = config_for(rules, side, agents);
  for (auto _ : state) {
    BaselineWalk walk(rules, *config.box, agents, 1);
    for (std::uint64_t i = 0; i < *config.max_steps; ++i) walk.step();
    benchmark::DoNotOptimize(walk.deposits());
  }
  report(state);
}

void engine(benchmark::State& state, bool vectorise, Motion motion = Motion::walk) {
  const RuleSet rules = around_a_nest();
  const RuleTable table(rules);
  SwarmConfig config =
      config_for(rules, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  config.vectorise = vectorise;
  config.motion = motion;
  for (auto _ : state) {
    SwarmResult result = run_swarm(table, rules.start, config);
    if (result.steps != *config.max_steps) state.SkipWithError("the run ended early");
  }
  report(state);
}
void engine_scalar(benchmark::State& state) { engine(state, false); }
void engine_vector(benchmark::State& state) { engine(state, true); }
void teleport(benchmark::State& state) { engine(state, true, Motion::teleport); }

const std::vector<std::vector<std::int64_t>> kCases{{20, 100}, {100, 1000}};

BENCHMARK(baseline)
    ->ArgsProduct(kCases)
    ->ArgNames({"side", "agents"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(engine_scalar)
    ->ArgsProduct(kCases)
    ->ArgNames({"side", "agents"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(engine_vector)
    ->ArgsProduct(kCases)
    ->ArgNames({"side", "agents"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(teleport)
    ->ArgsProduct(kCases)
    ->ArgNames({"side", "agents"})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stig::bench
