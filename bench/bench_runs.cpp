// SPDX-License-Identifier: MIT
// Ensembles: 64 runs of architecture-4n by walking agents on 1 and on 2 threads.
#include <benchmark/benchmark.h>

#include "lattice/swarm.h"
#include "shipped.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

void ensemble(benchmark::State& state) {
  const RuleSet rules = shipped("architecture-4n");
  const RuleTable table(rules);
  SwarmConfig config;
  config.box = lay_box({{20, 20, 20}, std::nullopt, false}, rules.start, rules.floor);
  config.agents = 100;
  config.max_steps = 20'000;
  for (auto _ : state) {
    const auto runs =
        run_ensemble(table, rules.start, config, 64, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(runs.size());
  }
}

BENCHMARK(ensemble)->Arg(1)->Arg(2)->ArgName("threads")->UseRealTime()->Unit(
    benchmark::kMillisecond);

}  // namespace
}  // namespace stig::bench
