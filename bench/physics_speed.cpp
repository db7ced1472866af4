// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "physical/trials.h"
#include "physics_rows.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

constexpr double kStockSeconds = 15;  ///< of processor time for each scene

struct Pace {
  double ms = 0;  ///< a step
  int steps = 0;
};

/// Mean of at most so many steps, ending early after that much processor time.
Pace pace(World& world, int steps, double most_seconds) {
  const double start = processor_seconds();
  Pace out;
  while (out.steps < steps && processor_seconds() - start < most_seconds && world.step().ok) {
    ++out.steps;
  }
  out.ms = (processor_seconds() - start) / std::max(1, out.steps) * 1e3;
  return out;
}

/// Milliseconds a step of DART on the scene's first steps, and the ratio to `own`.
std::string stock_pace(WorldConfig config, int steps, double own) {
  config.solver = SolverKind::stock;
  World world(config);
  const Pace stock = pace(world, steps, kStockSeconds);
  if (stock.steps < steps) {
    return fmt::format("{:.0f} ms, gave up after {} steps", stock.ms, stock.steps);
  }
  return fmt::format("{:.3g} ms, {:.0f} times", stock.ms, stock.ms / own);
}

/// A structure that may not sleep.
Row awake(const char* what, WorldConfig config, double bound, bool with_stock) {
  config.sleep.enabled = false;
  World world(config);
  static_cast<void>(pace(world, 20, 60));  // the first steps look for forces from nothing
  const Pace own = pace(world, 400, 60);
  return {fmt::format("{}, awake", what), fmt::format("{} ms a step", bound),
          fmt::format("{:.3g} ms, drift {:.2g} mm", own.ms, largest_drift(world, config) * 1e3),
          with_stock ? stock_pace(config, 100, own.ms) : "cannot finish", own.ms <= bound};
}

Rows structures(const BlockModel& block) {
  return {awake("pyramid of 15", pyramid_scene(block), 0.5, true),
          awake("wall of 100, 20 × 5", wall_scene(block, 20, 5), 3, false),
          awake("wall of 100, 10 × 10", wall_scene(block, 10, 10), 3, false)};
}

/// Blocks on the floor 14 mm apart: too far to move, near enough to pull.
Rows apart(const BlockModel& block) {
  WorldConfig config = scene_settings({0.2, 1});
  for (int i = 0; i < 500; ++i) {
    config.bodies.push_back(block_body(
        block, {{i % 25 * 0.069, static_cast<double>(i / 25) * 0.069, block.side / 2 - 1e-5}, {}}));
  }
  return {awake("500 blocks 14 mm apart", config, 5, true)};
}

Rows asleep(const BlockModel& block) {
  WorldConfig config = village(block);
  // Something that moves, far from all of them.
  BodyDef rod = solid_body(Shape::box({0.05, 0.05, 0.05}), 1, {-5, 0, 0.03});
  rod.fixed = true;
  config.bodies.push_back(rod);
  World world(config);
  run_for(world, config, 0.5);
  const std::size_t awake = world.awake_count();
  const Pace all = pace(world, 2000, 60);
  world.set_velocity(BodyId{1000}, {0, 0.1, 0}, {});
  const Pace one = pace(world, 2000, 60);
  return {{"1000 blocks in 33 structures, asleep", "0.05 ms a step, 0 awake",
           fmt::format("{:.2g} ms, {} awake", all.ms, awake), "cannot finish",
           all.ms <= 0.05 && awake == 0},
          {"the same, and one body that moves", "1 ms a step", fmt::format("{:.2g} ms", one.ms), "",
           one.ms <= 1}};
}

/// Falling and colliding: until nine blocks of ten sleep. Settled: the ten seconds after all
/// do, or after 20 s.
Rows drop(const BlockModel& block, int count, double falling, double settled, bool with_stock) {
  const WorldConfig config =
      loose_blocks(block, fmt::format(STIG_SOURCE_DIR "/scenes/drops/loose_{}.csv", count));
  World world(config);
  const auto run_until = [&world](const std::function<bool()>& end) {
    const double time = world.time(), start = processor_seconds();
    while (!end() && world.step().ok) continue;
    return (world.time() - time) / std::max(processor_seconds() - start, 1e-6);
  };
  const double rtf = run_until(
      [&] { return world.tick() > 20 && world.awake_count() * 10 <= config.bodies.size(); });
  const double until = world.time(), ms = config.step / rtf * 1e3;
  run_until([&] { return world.awake_count() == 0 || world.time() > 20; });
  const double rest = world.time();
  const double rtf_after = run_until([&] { return world.time() >= rest + 10; });
  const std::string what = fmt::format("{} blocks dropped", count);
  return {
      {what + ", falling and colliding", fmt::format("RTF ≥ {}", falling),
       fmt::format("{:.3g} for {:.2f} s", rtf, until),
       with_stock ? stock_pace(config, static_cast<int>(until / config.step), ms) : "cannot finish",
       rtf >= falling},
      {what + ", settled", fmt::format("RTF ≥ {}", settled),
       fmt::format("{:.3g}, {} awake after {:.2f} s", rtf_after, world.awake_count(), rest), "",
       rtf_after >= settled}};
}

Rows drops(const BlockModel& block) {
  Rows rows = drop(block, 100, 8, 200, true);
  for (Row& row : drop(block, 500, 1.2, 50, true)) rows.push_back(std::move(row));
  return rows;
}

Rows memory(const BlockModel& block) {
  const WorldConfig config = loose_blocks(block, STIG_SOURCE_DIR "/scenes/drops/loose_500.csv");
  const auto blocks = static_cast<double>(config.bodies.size());
  const std::size_t before = allocated_bytes();
  peak_bytes(true);
  World world(config);
  run_for(world, config, 1);
  const double most = static_cast<double>(peak_bytes(false) - before) / blocks / 1024;
  const double now = static_cast<double>(allocated_bytes() - before) / blocks / 1024;
  return {{"memory of 500 dropped blocks, at most and at rest", "60 KB a block",
           fmt::format("{:.1f} KB, {:.1f} KB", most, now), "", most <= 60}};
}

}  // namespace

const std::vector<Trial> kSpeedTrials = {
    {"awake", structures}, {"apart", apart},   {"asleep", asleep},
    {"drop", drops},       {"memory", memory},
};

}  // namespace stig::bench
