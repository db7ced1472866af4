// SPDX-License-Identifier: MIT
// Blocks that are dropped become bodies of the world at once. The trace, the reader of the scene
// and checkpoints know them in advance by their names and their order (place_scene.cpp), so only
// counts have to be saved.
#include "physical/simulation/block_supply.h"

#include <algorithm>

#include "physical/simulation/run_state.h"

namespace stig::physics {

namespace {

AddResult add_block(RunState& run, const Pose& X_WB) {
  Addition addition;
  addition.bodies.push_back(block_body(run.scene->models[run.scene->stock_model], X_WB));
  const AddResult added = run.world.add(addition);
  if (added.problem.empty()) run.agents.add(run, static_cast<std::size_t>(added.body));
  return added;
}

// Distances are along the floor: what lies over or under the cache counts, at whatever height.
bool blocks_near(const RunState& run, const CacheSpawn& cache) {
  for (std::uint32_t i = 0; i < run.world.size(); ++i) {
    if (!run.placed.bodies[i].block) continue;
    const BodyState state = run.world.state(BodyId{i});
    const double x = state.X_WB.p.x - cache.at.x, y = state.X_WB.p.y - cache.at.y;
    if (!state.left && x * x + y * y < cache.radius * cache.radius) return true;
  }
  return false;
}

}  // namespace

BlockSupply::BlockSupply(const Scene& scene) : dropped_(scene.caches.size() + 1, 0) {}

AddResult BlockSupply::drop(RunState& run, const Pose& X_WB, bool& used_up) {
  used_up = dropped_.back() == run.scene->stock;
  if (used_up) return {};
  const AddResult added = add_block(run, X_WB);
  if (added.problem.empty()) ++dropped_.back();
  return added;
}

void BlockSupply::before_step(RunState& run, const RunHooks& /*hooks*/) {
  // Caches look five times a second, like observers.
  if (!looks_now(run)) return;
  for (std::size_t i = 0; i < run.scene->caches.size(); ++i) {
    const CacheSpawn& cache = run.scene->caches[i];
    if (dropped_[i] == cache.stock || blocks_near(run, cache)) continue;
    // The number of the drop is its address of noise: how often it was tried does not matter.
    const Pose X_WB =
        jittered({cache.at, rotation({0, 0, cache.yaw})}, cache.jitter, cache.turn_jitter,
                 run.placed.seed, kCacheJitter + static_cast<std::uint32_t>(i), dropped_[i]);
    // A robot may stand there: then later.
    if (add_block(run, X_WB).problem.empty()) ++dropped_[i];
  }
}

/// All that the world has beyond what it began with came from here.
bool BlockSupply::accept(const RunState& run) const {
  const auto& caches = run.scene->caches;
  std::size_t all = run.placed.config.bodies.size();
  for (std::size_t i = 0; i < dropped_.size(); ++i) {
    if (dropped_[i] > (i < caches.size() ? caches[i].stock : run.scene->stock)) return false;
    all += dropped_[i];
  }
  return all == run.world.size();
}

}  // namespace stig::physics
