// SPDX-License-Identifier: MIT
#include "physical/simulation/verify_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "physical/simulation/simulation.h"

namespace stig::physics {

TraceComparison verify_trace(const PoseTrace& trace, const LoadedScene& loaded,
                             const RunHooks& hooks, const ControllerFactory& controllers) {
  assert(loaded.placed.config.step > 0);
  TraceComparison report;
  Simulation run(loaded.scene, loaded.placed, false, controllers);
  const double step = loaded.placed.config.step;
  // Where scripts or programs ended it, or physics could not go on, the beginning of a step of
  // which no end came has left its marks; and a script has had its last words.
  const RunEnd why = trace.end.why;
  const std::uint64_t begun =
      why == RunEnd::script || why == RunEnd::failed || why == RunEnd::diverged ? 1 : 0;
  const auto compare = [&](const TraceHash& expected, bool last) {
    const std::uint64_t ticks = expected.tick + (last ? begun : 0);
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
  };
  report.identical = std::all_of(trace.hashes.begin(), trace.hashes.end(),
                                 [&](const TraceHash& one) { return compare(one, false); }) &&
                     compare({trace.end.ticks, trace.end.hash}, true);
  return report;
}

}  // namespace stig::physics
