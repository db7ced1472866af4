// SPDX-License-Identifier: MIT
// The physical world: milliseconds a step of structures that may not sleep, real-time factor
// of falling blocks, and the magnets of many blocks alone. `drift_mm` is how far the block
// that moved most has moved; `stock` is DART's own step on the same scene.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "physical/block.h"
#include "physical/magnetism.h"
#include "physical/scenes.h"
#include "physical/world.h"
#if STIG_WITH_DART
#include "physical/stock_world.h"
#endif

namespace stig::bench {
namespace {

BlockModel paper_block() {
  Diagnostics diagnostics;
  const auto block = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  if (block) return *block;
  std::fputs(to_text(diagnostics).c_str(), stderr);
  std::exit(1);
}

WorldConfig pyramid() { return pyramid_scene(paper_block()); }
WorldConfig low_wall() { return wall_scene(paper_block(), 20, 5); }
WorldConfig high_wall() { return wall_scene(paper_block(), 10, 10); }
WorldConfig apart() {
  // 500 blocks on the floor, 1 cm apart: too far to move, near enough to pull.
  WorldConfig config = scene_settings({0.2, 1});
  const BlockModel block = paper_block();
  for (int i = 0; i < 500; ++i) {
    config.bodies.push_back(
        block_body(block, {{i % 25 * 0.069, i / 25 * 0.069, block.side / 2 - 1e-5}, {}}));
  }
  return config;
}

template <class AnyWorld>
double drift_mm(const AnyWorld& world, const WorldConfig& config) {
  double most = 0;
  for (std::uint32_t i = 0; i < config.bodies.size(); ++i) {
    const Vec3 way = world.state(BodyId{i}).X_WB.p - config.bodies[i].X_WB.p;
    most = std::max(most, length(way));
  }
  return most * 1e3;
}

template <class AnyWorld>
void stay_awake(benchmark::State& state, WorldConfig (*make)()) {
  WorldConfig config = make();
  config.sleep.enabled = false;
  AnyWorld world(config);
  // The first step searches forces from nothing.
  for (int i = 0; i < 5; ++i) static_cast<void>(world.step());
  for (auto _ : state) {
    if (!world.step().ok) state.SkipWithError("diverged");
  }
  state.counters["drift_mm"] = drift_mm(world, config);
}
void awake(benchmark::State& state, WorldConfig (*make)()) { stay_awake<World>(state, make); }
BENCHMARK_CAPTURE(awake, pyramid_15, pyramid)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(awake, wall_20x5, low_wall)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(awake, wall_10x10, high_wall)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(awake, apart_500, apart)->Unit(benchmark::kMillisecond);
#if STIG_WITH_DART
void stock_awake(benchmark::State& state, WorldConfig (*make)()) {
  stay_awake<StockWorld>(state, make);
}
BENCHMARK_CAPTURE(stock_awake, pyramid_15, pyramid)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stock_awake, apart_500, apart)->Unit(benchmark::kMillisecond)->Iterations(20);
#endif

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Three seconds of falling, then two of what is left to do; RTF is simulated time by the
/// processor's, so that other programs on the machine do not count.
void drop(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const WorldConfig config = drop_scene(paper_block(), count);
  for (auto _ : state) {
    World world(config);
    const double start = processor_seconds();
    while (world.time() < 3 && world.step().ok) continue;
    const double middle = processor_seconds();
    state.counters["awake_after_3s"] = static_cast<double>(world.awake_count());
    while (world.time() < 5 && world.step().ok) continue;
    const double end = processor_seconds();
    state.counters["rtf_falling"] = 3 / (middle - start);
    state.counters["rtf_settled"] = 2 / (end - middle);
  }
}
BENCHMARK(drop)->Arg(100)->Arg(500)->Unit(benchmark::kMillisecond)->Iterations(1);

/// The magnets alone: pairs, directions and forces of blocks 1 cm apart.
void magnets(benchmark::State& state) {
  const WorldConfig config = apart();
  std::vector<Magnet> all;
  std::vector<MagnetOwner> owners;
  for (std::uint32_t i = 0; i < config.bodies.size(); ++i) {
    const BodyDef& def = config.bodies[i];
    MagnetOwner owner{static_cast<std::uint32_t>(all.size()), 0, def.X_WB.p, true};
    for (const MagnetDef& magnet : def.magnets) {
      all.push_back({i, true, def.X_WB.p + magnet.p_B, magnet.direction, magnet.moment});
    }
    owner.end = static_cast<std::uint32_t>(all.size());
    owners.push_back(owner);
  }
  std::size_t pairs_found = 0;
  for (auto _ : state) {
    const auto pairs = magnet_pairs(all, owners, 0.039, config.magnet_cutoff);
    relax_magnets(all, pairs, owners, config.step, config.relaxation);
    Vec3 sum;
    for (const MagnetPair& pair : pairs) {
      const Magnet &a = all[pair.i], &b = all[pair.j];
      sum += dipole_wrench(a.direction * a.moment, b.direction * b.moment, pair.r).force;
    }
    benchmark::DoNotOptimize(sum);
    pairs_found = pairs.size();
  }
  state.counters["pairs"] = static_cast<double>(pairs_found);
}
BENCHMARK(magnets)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stig::bench
