// SPDX-License-Identifier: MIT
// Two orders: that in which parts work in a tick, and that in which their bytes lie. They are apart
// since the first may have to change where the second must not. The script works before the supply,
// so that what it drops is not dropped twice; agents after all that moves things, so that
// controllers see a world that will stand still until the step; the recorder after agents, for what
// they said.
#include "physical/simulation/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "physical/simulation/hand_work.h"

namespace stig::physics {

namespace {

/// In the order in which they work.
std::array<RunPart*, 7> parts_at_work(RunState& run) {
  return {&run.odometer, &run.script,   &run.supply, &run.pushes,
          &run.agents,   &run.recorder, &run.tally};
}

/// In the order in which their bytes follow those of the world, which come first since parts ask
/// for its size when they are loaded.
template <class Run>
auto saved_parts(Run& run) {
  return std::array<std::conditional_t<std::is_const_v<Run>, const RunPart*, RunPart*>, 6>{
      &run.tally, &run.supply, &run.odometer, &run.pushes, &run.script, &run.agents};
}

/// Takes up a state in a run that has not begun, which is of no use when this is false.
bool load(RunState& run, std::string_view state) {
  ByteReader bytes(state);
  if (!run.world.resume(bytes.block())) return false;
  if (run.world.size() > run.placed.bodies.size()) return false;
  BytesIn in(bytes);
  const auto parts = saved_parts(run);
  return std::all_of(parts.begin(), parts.end(),
                     [&](RunPart* part) { return part->load(in, run); }) &&
         bytes.left() == 0;
}

std::string divergence(const RunState& run, BodyId body) {
  return fmt::format("physics diverged in tick {} ({:.3f} s) at '{}'", run.world.tick() + 1,
                     run.world.time(), run.placed.bodies[static_cast<std::size_t>(body)].name);
}

/// Whether it has come to rest, where that ends it. A run that has not begun has not.
bool at_rest(const RunState& run) {
  return run.scene->stop_asleep && run.world.tick() > 0 && run.world.awake_count() == 0;
}

}  // namespace

RunEnd Simulation::until(double duration, const RunHooks& hooks) {
  const auto parts = parts_at_work(run_);
  // A multiple of the step that rounding has put a hair above the duration is its end.
  const auto last =
      static_cast<std::uint64_t>(std::ceil(duration / run_.placed.config.step - 1e-6));
  // One that had ended so and was brought back makes no step more.
  if (run_.world.tick() < last && at_rest(run_)) return RunEnd::asleep;
  while (run_.world.tick() < last) {
    if (run_.stop) return RunEnd::script;
    if (hooks.stop != nullptr && hooks.stop->load(std::memory_order_relaxed)) {
      return RunEnd::interrupted;
    }
    // Parts first, then the step, then parts again with what it did.
    for (RunPart* part : parts) part->before_step(run_, hooks);
    if (run_.stop) return RunEnd::script;
    if (scene().stop_failed && crew() != nullptr && crew()->all_failed()) return RunEnd::failed;
    const StepResult result = run_.world.step();
    if (!result.ok) {
      run_.message = divergence(run_, result.body);
      return RunEnd::diverged;
    }
    for (RunPart* part : parts) part->after_step(run_);
    if (hooks.after_step) hooks.after_step(run_.world);
    if (at_rest(run_)) return RunEnd::asleep;
  }
  return RunEnd::duration;
}

std::string Simulation::intervene(const HandAction& action) {
  std::string problem = work_by_hand(run_, action);
  if (problem.empty()) run_.recorder.hand(run_, action);
  return problem;
}

std::string Simulation::state() const {
  // Without histories of readings there is no way to bring programs back.
  assert(run_.resumable);
  BytesOut out;
  out(run_.world.checkpoint());
  for (const RunPart* part : saved_parts(run_)) part->save(out);
  return out.take();
}

bool Simulation::resume(std::string_view state) {
  // A new run is filled and takes the old one's place only when all of it was good.
  RunState next(*run_.scene, run_.placed, run_.resumable, run_.controllers);
  if (!load(next, state)) return false;
  next.recorder.take_over(run_.recorder);
  run_ = std::move(next);
  return true;
}

}  // namespace stig::physics
