// SPDX-License-Identifier: MIT
// Agent-steps per second of the walk engine on architecture-4n, with and without
// vector instructions, beside the baseline in the same run; "x" counters are ratios
// to the baseline's median for the same box and agents.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "baseline_walk.h"
#include "lattice/swarm.h"
#include "shipped.h"

namespace stig::bench {
namespace {

constexpr std::uint64_t kAgentSteps = 4'000'000;

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
  const RuleSet rules = shipped("architecture-4n");
  const auto side = static_cast<int>(state.range(0)), agents = static_cast<int>(state.range(1));
  const SwarmConfig config = config_for(rules, side, agents);
  for (auto _ : state) {
    BaselineWalk walk(rules, *config.box, agents, 1);
    for (std::uint64_t i = 0; i < *config.max_steps; ++i) walk.step();
    benchmark::DoNotOptimize(walk.deposits());
  }
  report(state);
}

void engine(benchmark::State& state, bool vectorise) {
  const RuleSet rules = shipped("architecture-4n");
  const RuleTable table(rules);
  SwarmConfig config =
      config_for(rules, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  config.vectorise = vectorise;
  for (auto _ : state) {
    SwarmResult result = run_swarm(table, rules.start, config);
    benchmark::DoNotOptimize(result.deposits);
  }
  report(state);
}
void engine_scalar(benchmark::State& state) { engine(state, false); }
void engine_vector(benchmark::State& state) { engine(state, true); }

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

}  // namespace
}  // namespace stig::bench
