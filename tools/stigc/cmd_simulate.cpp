// SPDX-License-Identifier: MIT
// stigc simulate: a scene, once or for many seeds.
//
// One run with its files, or many for their figures. What makes one run long is resume: a run that
// was interrupted goes on from a checkpoint and ends with the same bytes in its trace as if it had
// not been. So a checkpoint names everything itself, and what the command line could contradict is
// refused.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file_guard.h"
#include "base/file_io.h"
#include "camera_place.h"
#include "commands.h"
#include "outputs.h"
#include "physical/simulation/checkpoint_file.h"
#include "physical/simulation/run_picture.h"
#include "progress.h"
#include "report.h"
#include "scene_input.h"
#include "simulate_report.h"
#include "simulate_runs.h"
#include "trace_file.h"

namespace stig::cli {
namespace {

constexpr std::size_t kMostFileBytes = std::size_t{1} << 30;

/// What is wrong with the options together; empty: nothing.
std::string usage_problem(const SimulateOptions& o) {
  if (o.scene.empty() && !o.resume) return "a scene is wanted, or --resume and a checkpoint";
  if (!o.scene.empty() && o.resume) return "a checkpoint holds its scene: leave SCENE out";
  if (o.resume && o.seed) return "a checkpoint holds its seed: leave --seed out";
  if (o.at && !o.picture) return "--at is the moment of a picture: add -o FILE.png";
  if (o.camera && !o.picture) return "--camera says what a picture shows: add -o FILE.png";
  if (o.detail && !o.trace) return "--trace-detail says what a trace has: add --trace FILE.stigp";
  if (o.detail && o.resume) return "a resumed run goes on in its trace: leave --trace-detail out";
  if (o.picture && !o.picture->ends_with(".png")) {
    return fmt::format("'{}': pictures of scenes are .png", *o.picture);
  }
  // An ensemble keeps figures alone.
  if (o.runs > 1 && (o.trace || o.picture || o.checkpoint || o.resume)) {
    return "--trace, -o, --checkpoint and --resume are of one run, not of --runs";
  }
  return {};
}

/// Every file that is written.
std::vector<std::string> output_names(const SimulateOptions& o) {
  std::vector<std::string> names;
  for (const auto& path : {o.trace, o.picture, o.checkpoint}) {
    if (path) names.push_back(*path);
  }
  return names;
}

/// A resumed run goes on in its trace, and may leave its checkpoint where the last one was. Files
/// that have been read are not written over otherwise (file_guard.h).
void let_go_on(const SimulateOptions& o) {
  if (o.trace) let_replace(*o.trace);
  if (o.checkpoint && file_identity(*o.checkpoint) == file_identity(*o.resume)) {
    let_replace(*o.checkpoint);
  }
}

std::optional<Checkpoint> read_checkpoint(const std::string& path, const App& app) {
  FileError error;
  const auto bytes = read_file(path, kMostFileBytes, error);
  std::string problem;
  auto checkpoint = bytes ? read_checkpoint_file(*bytes, problem) : std::nullopt;
  if (!bytes) app.complain(error.message);
  if (bytes && !checkpoint) app.complain(fmt::format("'{}': {}", printable(path), problem));
  return checkpoint;
}

std::optional<LoadedScene> scene_of(const Checkpoint& checkpoint, const App& app) {
  Diagnostics diagnostics;
  auto loaded = load_scene(checkpoint.files, checkpoint.seed, diagnostics);
  if (!loaded) app.report(diagnostics);
  return loaded;
}

// Names in order too: the scene's own comes first.
bool same_files(const std::vector<SceneFile>& a, const std::vector<SceneFile>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.name == y.name && x.text == y.text;
  });
}

/// The trace of the run so far, when it is that.
std::optional<PoseTrace> earlier_trace(const std::string& path, const PoseTraceHeader& header,
                                       std::uint64_t tick, const App& app) {
  FileError error;
  auto bytes = read_file(path, kMostFileBytes, error);
  if (!bytes) {
    app.complain(error.message + "; --trace with --resume names the trace of the run so far");
    return std::nullopt;
  }
  Diagnostics diagnostics;
  auto trace = read_pose_trace(path, std::move(*bytes), diagnostics);
  if (!trace) {
    app.report(diagnostics);
    return std::nullopt;
  }
  // Same seed and same texts: then the run is the same.
  const bool same =
      trace->header.seed == header.seed && same_files(trace->header.files, header.files);
  // Ticks beyond the checkpoint are left out when the trace is copied.
  if (same && trace->end.ticks >= tick) return trace;
  app.complain(fmt::format("'{}' is {}", printable(path),
                           same ? "shorter than the run was at the checkpoint"
                                : "the trace of another run than the checkpoint"));
  return std::nullopt;
}

/// One run, from its beginning or a checkpoint, with its files.
class OneRun {
 public:
  OneRun(const SimulateOptions& options, const LoadedScene& loaded, App& app)
      : options_(options),
        loaded_(loaded),
        app_(app),
        // Histories of readings are kept only where a checkpoint is wanted: they take memory.
        run_(loaded.scene, loaded.placed, options.checkpoint.has_value()) {}

  int run(const std::optional<Checkpoint>& checkpoint) {
    if (checkpoint && !run_.resume(checkpoint->state)) {
      // The scene has read well, so the state must be damaged or of another version.
      app_.complain(
          fmt::format("'{}': its state is none of its scene", printable(*options_.resume)));
      return kFailed;
    }
    if (!find_camera()) return kUsage;
    if (const int code = begin_trace(); code != kOk) return code;
    stop_on_signals();
    // Otherwise a moment is looked for behind each step.
    if (options_.at && *options_.at == 0 && !checkpoint) take_moment();
    Progress progress(app_);
    const RunEnd end = run_.until(duration(), hooks(progress));
    const double seconds = progress.seconds();
    progress.clear();
    // Before the script's last words, which a run that goes on has not heard yet.
    if (options_.checkpoint) state_ = run_.state();
    run_.end_script(hooks(progress));
    // Ends the trace on the last tick, whatever ended the run.
    run_.finish(end);
    const int written = write_files();
    const SimulationReport report = report_of(loaded_.scene, run_, end, seconds);
    print(report);
    if (end == RunEnd::diverged || run_.script_failed()) app_.complain(printable(run_.message()));
    if (end == RunEnd::interrupted) {
      app_.complain(fmt::format("interrupted after {:.3f} s", run_.world().time()));
    }
    // 3 where the work was broken off, 1 where it came to an end that is not good.
    if (run_.script_failed() || end == RunEnd::diverged || end == RunEnd::interrupted) {
      return kRunFailed;
    }
    if (written == kOk && report.programs_failed) app_.complain(std::string(kProgramsFailed));
    return written == kOk && report.programs_failed ? kFailed : written;
  }

 private:
  double step() const { return loaded_.placed.config.step; }
  double duration() const { return options_.duration.value_or(loaded_.scene.duration); }

  int begin_trace() {
    if (!options_.trace) return kOk;
    PoseTraceHeader header = trace_header(loaded_.scene, loaded_.placed, options_.detail);
    std::optional<PoseTrace> earlier;
    if (options_.resume) {
      // The trace may be longer than the run up to the checkpoint, never shorter.
      earlier = earlier_trace(*options_.trace, header, run_.world().tick(), app_);
      if (!earlier) return kFailed;
      header.channels = earlier->header.channels;
    }
    if (!trace_.open(*options_.trace)) {
      app_.complain(trace_.error());
      return kRunFailed;
    }
    PoseTraceWriter& writer = trace_.begin(header);
    // Copied records are re-encoded, so chunks fall as in an uninterrupted run.
    if (earlier) copy_records(*earlier, run_.world().tick(), writer);
    run_.record(writer);
    return kOk;
  }

  RunHooks hooks(Progress& progress) {
    RunHooks hooks;
    hooks.stop = &stop_requested();
    hooks.on_line = [this, &progress](const CrewLine& line) {
      // The line of progress must not end up in the middle of a message.
      progress.clear();
      const std::string text =
          fmt::format("{:8.2f} s  {}: {}", static_cast<double>(line.tick) * step(),
                      printable(line.who), printable(line.text));
      if (line.failure) {
        app_.complain(text);
      } else {
        app_.say(text);
      }
    };
    hooks.after_step = [this, &progress](const World& world) {
      // Sixteen steps are a fraction of what a frame on the terminal takes.
      if (world.tick() % 16 == 0) {
        progress.show(world.time() / duration(),
                      fmt::format("{:.1f} of {} s, {} of {} awake", world.time(), duration(),
                                  world.awake_count(), world.size()));
      }
      // Times are sums of steps, and may be a hair below the moment.
      if (options_.at && !moment_ && world.time() >= *options_.at - 1e-9) take_moment();
    };
    return hooks;
  }

  bool find_camera() {
    if (!options_.camera) return true;
    std::string problem;
    camera_ = camera_named(run_, *options_.camera, problem);
    if (!camera_) app_.complain(printable(problem));
    return camera_.has_value();
  }

  void take_moment() {
    moment_ = {run_.world().time(), {}, {}, {}};
    if (camera_) {
      moment_->view = view_png(run_, *camera_);
    } else {
      // Bodies and lines are kept, and drawn at the end: drawing takes longer than many steps.
      moment_->bodies = picture_bodies(run_);
      moment_->lines = picture_lines(run_);
    }
  }

  int write_files() {
    int code = options_.trace ? commit(trace_, app_) : kOk;
    if (options_.picture) code = std::max(code, write_moment());
    if (options_.checkpoint) code = std::max(code, write_checkpoint());
    return code;
  }

  int write_moment() {
    // A picture is wanted in any case; its caption has the time.
    if (options_.at && !moment_) {
      app_.say(fmt::format("the run ended before {} s: the picture is of its end", *options_.at));
    }
    if (!moment_) take_moment();
    if (camera_) return write_output(*options_.picture, moment_->view, app_);
    std::string error;
    const bool good =
        write_picture(*options_.picture, moment_->bodies, moment_->lines,
                      loaded_.placed.config.floor, loaded_.scene.title, moment_->time, error);
    if (good) {
      app_.say("wrote " + printable(*options_.picture));
    } else {
      app_.complain(error);
    }
    return good ? kOk : kRunFailed;
  }

  int write_checkpoint() {
    // The state was taken before the script's last words.
    return write_output(*options_.checkpoint,
                        checkpoint_bytes({loaded_.scene.files, loaded_.placed.seed, state_}), app_);
  }

  void print(const SimulationReport& report) {
    app_.print(options_.json ? dump(to_json(report)) : lines_of(report, true));
  }

  struct Moment {
    double time = 0;
    std::vector<PictureBody> bodies;
    std::vector<PictureLine> lines;
    std::string view;  ///< a PNG file, of a camera
  };

  const SimulateOptions& options_;
  const LoadedScene& loaded_;
  App& app_;
  Simulation run_;
  TraceFile trace_;
  std::optional<Moment> moment_;
  std::optional<CameraPlace> camera_;
  std::string state_;  ///< for the checkpoint
};

}  // namespace

int run(const SimulateOptions& options, App& app) {
  const std::string problem = usage_problem(options);
  if (!problem.empty()) {
    app.complain(printable(problem));
    return kUsage;
  }
  std::optional<Checkpoint> checkpoint;
  if (options.resume) {
    checkpoint = read_checkpoint(*options.resume, app);
    if (!checkpoint) return kFailed;
    // Before check_outputs asks whether these names may be written.
    let_go_on(options);
  }
  const auto loaded =
      checkpoint ? scene_of(*checkpoint, app) : read_loaded_scene(options.scene, options.seed, app);
  if (!loaded) return kFailed;
  if (const int code = check_outputs(output_names(options), app); code != kOk) return code;
  if (options.runs > 1) return simulate_runs(options, loaded->scene, app);
  return OneRun(options, *loaded, app).run(checkpoint);
}

}  // namespace stig::cli
