// SPDX-License-Identifier: MIT
// Runs differ by their seeds and share nothing, so threads take the next one that is free. Reports
// are kept by run: what is printed does not depend on who was first.
#include "simulate_runs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/parallel.h"
#include "progress.h"
#include "report.h"
#include "simulate_report.h"

namespace stig::cli {
namespace {

/// One seed; nothing when it has no place for the blocks, which `diagnostics` then says.
std::optional<SimulationReport> one_run(const Scene& scene, std::uint64_t seed, double duration,
                                        Diagnostics& diagnostics) {
  const auto placed = place_scene(scene, seed, diagnostics);
  if (!placed) return std::nullopt;
  // Nobody resumes one of many runs.
  Simulation run(scene, *placed, false);
  RunHooks hooks;
  hooks.stop = &stop_requested();
  // Time by the clock, which the JSON of each run tells.
  const auto began = std::chrono::steady_clock::now();
  const RunEnd end = run.until(duration, hooks);
  run.end_script(hooks);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  return report_of(scene, run, end, took.count());
}

/// Means, for the last line.
std::string means_of(const std::vector<SimulationReport>& runs) {
  double time = 0, snapped = 0, largest = 0;
  for (const SimulationReport& r : runs) {
    const auto& lattices = r.structure.lattices;
    time += r.time;
    snapped += static_cast<double>(r.tally.snapped);
    largest += lattices.empty() ? 0 : static_cast<double>(lattices[0].blocks.size());
  }
  const auto n = static_cast<double>(runs.size());
  return fmt::format("mean of {} runs: {:.3f} s, snapped {:.1f} times, largest lattice {:.1f}\n",
                     runs.size(), time / n, snapped / n, largest / n);
}

struct Results {
  std::vector<std::optional<SimulationReport>> reports;
  std::vector<Diagnostics> diagnostics;
};

Results run_all_seeds(const SimulateOptions& options, const Scene& scene, const App& app) {
  const auto runs = static_cast<std::size_t>(options.runs);
  Results results{std::vector<std::optional<SimulationReport>>(runs),
                  std::vector<Diagnostics>(runs)};
  const std::uint64_t first = options.seed.value_or(scene.seed);
  const double duration = options.duration.value_or(scene.duration);
  std::atomic<std::size_t> done{0};
  Progress progress(app);
  const auto work = [&](std::size_t i) {
    // Each run has places of its own in both lists: no lock is needed.
    results.reports[i] = one_run(scene, first + i, duration, results.diagnostics[i]);
    const std::size_t finished = ++done;
    progress.show(static_cast<double>(finished) / static_cast<double>(runs),
                  fmt::format("{} of {} runs", finished, runs));
  };
  run_parallel(runs, thread_count(options.threads), work, [] { return stop_requested().load(); });
  return results;
}

}  // namespace

int simulate_runs(const SimulateOptions& options, const Scene& scene, App& app) {
  stop_on_signals();
  const Results results = run_all_seeds(options, scene, app);
  std::vector<SimulationReport> finished;
  bool good = true, placed = true, programs_failed = false;
  for (std::size_t i = 0; i < results.reports.size(); ++i) {
    if (results.diagnostics[i].has_errors()) app.report(results.diagnostics[i]);
    placed = placed && !results.diagnostics[i].has_errors();
    const auto& report = results.reports[i];
    good = good && report && report->end != RunEnd::diverged &&
           report->end != RunEnd::interrupted && !report->script_failed;
    // An interrupted run is no sample; one that diverged is a result.
    if (!report || report->end == RunEnd::interrupted) continue;
    finished.push_back(*report);
    if (!report->programs_failed) continue;
    programs_failed = true;
    app.complain(fmt::format("seed {}: {}", report->seed, kProgramsFailed));
  }
  if (options.json) {
    Json json = {{"runs", Json::array()}};
    for (const SimulationReport& report : finished) json["runs"].push_back(to_json(report));
    app.print(dump(json));
  } else if (!finished.empty()) {
    app.print(table_of(finished) + means_of(finished));
  }
  if (!placed) return kFailed;
  if (!good) return kRunFailed;
  return programs_failed ? kFailed : kOk;
}

}  // namespace stig::cli
