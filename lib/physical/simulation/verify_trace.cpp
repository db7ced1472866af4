// SPDX-License-Identifier: MIT
#include "physical/simulation/verify_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "physical/simulation/simulation.h"

namespace stig::physics {

namespace {

/// A run that does again what a trace holds, and how far both agree.
struct Repetition {
  const PoseTrace& trace;
  const RunHooks& hooks;
  double step;
  Simulation run;
  TraceComparison report;
  std::size_t hand = 0;  ///< acts of hands done so far

  bool work_by_hand_before(std::uint64_t tick);
  bool compare(const TraceHash& expected, bool last);
};

/// What was done by hand in ticks before this one is done again, each in its tick.
bool Repetition::work_by_hand_before(std::uint64_t tick) {
  for (; hand < trace.hands.size() && trace.hands[hand].tick < tick; ++hand) {
    const TraceHand& done = trace.hands[hand];
    run.until(static_cast<double>(done.tick) * step, hooks);
    // A run that has ended before is told by the comparison that follows.
    if (run.world().tick() != done.tick) return true;
    const std::string problem = run.intervene(done.action);
    if (problem.empty()) continue;
    report.difference = fmt::format("what was done by hand in tick {} cannot be done again: {}",
                                    done.tick, problem);
    return false;
  }
  return true;
}

bool Repetition::compare(const TraceHash& expected, bool last) {
  // Where scripts or programs ended it, or physics could not go on, the beginning of a step of
  // which no end came has left its marks; and a script has had its last words.
  const RunEnd why = trace.end.why;
  const bool begun = why == RunEnd::script || why == RunEnd::failed || why == RunEnd::diverged;
  if (!work_by_hand_before(expected.tick + (last ? 1 : 0))) return false;
  const std::uint64_t ticks = expected.tick + (last && begun ? 1 : 0);
  const RunEnd end = run.until(static_cast<double>(ticks) * step, hooks);
  if (last) run.end_script(hooks);
  if (end == RunEnd::interrupted) {
    report.interrupted = true;
    report.difference = "the comparison was interrupted";
  } else if (run.world().tick() != expected.tick) {
    report.difference =
        fmt::format("it ends in tick {}, before tick {}", run.world().tick(), expected.tick);
  } else if (run.hash() != expected.hash) {
    report.difference = fmt::format("the state in tick {} is another", expected.tick);
  } else {
    ++report.compared;
  }
  return report.difference.empty();
}

}  // namespace

TraceComparison verify_trace(const PoseTrace& trace, const LoadedScene& loaded,
                             const RunHooks& hooks, const ControllerFactory& controllers) {
  const double step = loaded.placed.config.step;
  assert(step > 0);
  Repetition again{
      trace, hooks, step, Simulation(loaded.scene, loaded.placed, false, controllers), {}};
  const bool so_far = std::all_of(trace.hashes.begin(), trace.hashes.end(),
                                  [&](const TraceHash& one) { return again.compare(one, false); });
  again.report.identical = so_far && again.compare({trace.end.ticks, trace.end.hash}, true);
  return again.report;
}

}  // namespace stig::physics
