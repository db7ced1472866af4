// SPDX-License-Identifier: MIT
// Event motion: deposits per second of every shipped set in a 20³ box, and the growth of an
// endless rule set to ten million bricks with the memory it takes.
#include <benchmark/benchmark.h>

#include "lattice/swarm.h"
#include "shipped.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

void deposits(benchmark::State& state, const std::string& name, int side) {
  const RuleSet rules = shipped(name);
  const RuleTable table(rules);
  SwarmConfig config;
  config.motion = Motion::event;
  config.box = lay_box({{side, side, side}, std::nullopt, false}, rules.start, rules.floor);
  std::uint64_t placed = 0;
  for (auto _ : state) {
    placed += run_swarm(table, rules.start, config).deposits;
    ++config.run;
  }
  state.counters["deposits/s"] =
      benchmark::Counter(static_cast<double>(placed), benchmark::Counter::kIsRate);
  state.counters["deposits/run"] =
      static_cast<double>(placed) / static_cast<double>(state.iterations());
}

/// A sheet of three colours that has no end.
void endless(benchmark::State& state) {
  const RuleSet rules = shipped("tiling");
  const RuleTable table(rules);
  SwarmConfig config;
  config.motion = Motion::event;
  config.max_deposits = static_cast<std::uint64_t>(state.range(0));
  for (auto _ : state) {
    const SwarmResult result = run_swarm(table, rules.start, config);
    if (result.deposits != *config.max_deposits) state.SkipWithError("growth ended early");
  }
  state.counters["deposits/s"] = benchmark::Counter(
      static_cast<double>(state.range(0)) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
  state.counters["peak_MB"] = peak_megabytes();
}

const bool kEverySet = [] {
  for (const std::string& name : shipped_names()) {
    benchmark::RegisterBenchmark(("deposits/" + name + "_20").c_str(), deposits, name, 20)
        ->Unit(benchmark::kMicrosecond);
  }
  return true;
}();
BENCHMARK(endless)->Arg(10'000'000)->Iterations(1)->Unit(benchmark::kSecond);

}  // namespace
}  // namespace stig::bench
