// SPDX-License-Identifier: MIT
// World::push acts for a single step; what acts longer is pushed again in each.
#include "physical/simulation/force_pushes.h"

#include <algorithm>
#include <cassert>

#include "physical/simulation/run_state.h"

namespace stig::physics {

namespace {

constexpr std::size_t kMostPushes = 1000;  ///< at a time

}  // namespace

// With 0 ticks it is gone before the step: scripts ask for one at least.
bool ForcePushes::add(const RunState& run, BodyId body, const Vec3& force, std::uint64_t ticks) {
  assert(is_finite(force));
  if (pushes_.size() >= kMostPushes) return false;
  pushes_.push_back({static_cast<std::uint32_t>(body), run.world.tick() + ticks, force});
  return true;
}

void ForcePushes::before_step(RunState& run, const RunHooks& /*hooks*/) {
  std::erase_if(pushes_, [&](const Push& push) { return push.until <= run.world.tick(); });
  for (const Push& push : pushes_) run.world.push(BodyId{push.body}, push.force, {});
}

bool ForcePushes::accept(const RunState& run) const {
  return std::all_of(pushes_.begin(), pushes_.end(), [&](const Push& push) {
    return push.body < run.world.size() && is_finite(push.force);
  });
}

}  // namespace stig::physics
