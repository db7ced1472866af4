// SPDX-License-Identifier: MIT
// Runs are independent and are taken by threads as they come free; each has a slot of its own, and
// results are collected in the order of seeds, so that nothing depends on the number of threads.
#include "validate_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/file_guard.h"
#include "base/file_io.h"
#include "base/parallel.h"
#include "progress.h"
#include "trace_file.h"
#include "trace_rules.h"
#include "validation_folder.h"

namespace stig::cli {
namespace {

constexpr std::size_t kMostEndsDrawn = 12;  ///< runs whose end is drawn
constexpr int kPicturesOnTheWay = 4;        ///< of the first run

bool is_whole_trace(const std::string& path) {
  // One that is not is written over, although it is read here.
  if (!was_read(path)) let_replace(path);
  FileError error;
  Diagnostics problems;
  std::optional<std::string> bytes = read_file(path, kMostTraceBytes, error);
  return bytes && read_pose_trace(path, std::move(*bytes), problems);
}

struct Slot {
  std::optional<Trial> trial;
  Diagnostics diagnostics;
  TraceFile trace;
  bool traced = false, good = true, journalled = true;
  std::string trace_path;
};

class Batch {
 public:
  Batch(const BuildTarget& target, const Scene& scene, const ValidateOptions& options,
        double duration, bool pictures, TrialJournal& journal, const App& app)
      : target_(target),
        scene_(scene),
        options_(options),
        duration_(duration),
        pictures_(pictures),
        journal_(journal),
        app_(app),
        progress_(app),
        slots_(static_cast<std::size_t>(options.runs)),
        shares_(slots_.size()) {}

  TrialBatch run() {
    run_parallel(
        slots_.size(), thread_count(options_.threads), [this](std::size_t i) { one(i); },
        [] { return stop_requested().load(); });
    progress_.clear();
    return collect();
  }

 private:
  void one(std::size_t i) {
    Slot& slot = slots_[i];
    const std::uint64_t seed = options_.seed + i;
    if (take_earlier(slot, seed)) {
      shares_[i] = 1;
      ++done_;
      return;
    }
    const auto placed = place_scene(scene_, seed, slot.diagnostics);
    if (!placed) return;
    TrialSettings settings;
    settings.duration = duration_;
    // The first run has some on its way, the next ones have their end alone, and those after
    // kMostEndsDrawn have none.
    settings.pictures = !pictures_ || i >= kMostEndsDrawn ? -1 : i == 0 ? kPicturesOnTheWay : 0;
    if (options_.output) {
      slot.traced = true;
      slot.trace_path = *options_.output + "/" + trace_name(seed);
      slot.good = slot.trace.open(slot.trace_path);
      if (slot.good) {
        settings.trace = &slot.trace.begin(trace_header(scene_, *placed, options_.detail));
      }
    }
    TrialHooks hooks;
    hooks.stop = &stop_requested();
    hooks.progress = [this, i](double time, std::size_t bricks) { show(i, time, bricks); };
    slot.trial = run_trial(target_, scene_, *placed, settings, hooks);
    if (settings.trace != nullptr) slot.good = slot.trace.commit();
    // The trace first: a run that is in the journal has one.
    const bool over = slot.good && slot.trial->end != TrialEnd::interrupted;
    if (over && journal_.is_open()) slot.journalled = journal_.add(*slot.trial, app_);
    shares_[i] = 1;
    ++done_;
  }

  /// What an earlier command did, unless its trace was taken away or damaged meanwhile.
  bool take_earlier(Slot& slot, std::uint64_t seed) {
    const auto found = journal_.earlier().find(seed);
    if (found == journal_.earlier().end() || !options_.output) return false;
    slot.trace_path = *options_.output + "/" + trace_name(seed);
    if (!is_whole_trace(slot.trace_path)) return false;
    slot.trial = found->second;
    slot.traced = true;
    return true;
  }

  /// How far a run is: by bricks or by time, whichever is more.
  void show(std::size_t i, double time, std::size_t bricks) {
    const std::size_t start = target_.sites.size() * target_.rules->start.size();
    const std::size_t whole = target_.sites.size() * target_.whole.size();
    const auto wanted = static_cast<double>(std::max<std::size_t>(1, whole - start));
    const double built = bricks > start ? static_cast<double>(bricks - start) / wanted : 0;
    // Not quite full by bricks: ten seconds of standing are still to come.
    shares_[i] = std::clamp(std::max(built * 0.98, time / duration_), 0.0, 1.0);
    double sum = 0;
    for (const std::atomic<double>& share : shares_) sum += share;
    progress_.show(sum / static_cast<double>(slots_.size()),
                   slots_.size() == 1
                       ? fmt::format("{:.0f} s, {} of {} bricks", time, bricks, whole)
                       : fmt::format("{} of {} runs", done_.load(), slots_.size()));
  }

  TrialBatch collect() {
    TrialBatch out;
    for (Slot& slot : slots_) {
      if (slot.diagnostics.has_errors() && !out.diagnostics.has_errors()) {
        out.diagnostics = slot.diagnostics;
      }
      out.journalled = out.journalled && slot.journalled;
      if (slot.trial) out.trials.push_back(std::move(*slot.trial));
      if (!slot.traced) continue;
      if (slot.good) {
        out.written.push_back(slot.trace_path);
      } else {
        out.complaints.push_back(slot.trace.error());
      }
    }
    return out;
  }

  const BuildTarget& target_;
  const Scene& scene_;
  const ValidateOptions& options_;
  double duration_;
  bool pictures_;
  TrialJournal& journal_;
  const App& app_;
  Progress progress_;
  std::vector<Slot> slots_;
  std::vector<std::atomic<double>> shares_;
  std::atomic<std::size_t> done_{0};
};

}  // namespace

TrialBatch run_trials(const BuildTarget& target, const Scene& scene, const ValidateOptions& options,
                      double duration, bool pictures, TrialJournal& journal, const App& app) {
  return Batch(target, scene, options, duration, pictures, journal, app).run();
}

}  // namespace stig::cli
