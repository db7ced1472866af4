// SPDX-License-Identifier: MIT
// A trace of poses is looked at, or run again: it carries its scene and programs. The poses of a
// moment are decoded from the chunk around it (pose_trace_reader.cpp).
#include "pose_replay.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "base/hash.h"
#include "outputs.h"
#include "physical/simulation/verify_trace.h"
#include "pose_film.h"
#include "progress.h"
#include "report.h"
#include "simulate_report.h"
#include "view/pose_csv.h"
#include "view/pose_mcap.h"
#include "view/trace_picture.h"

namespace stig::cli {
namespace {

constexpr std::size_t kMostBodiesShown = 40, kWidestName = 40;

/// What a cache or a script has not dropped yet is nowhere, and has left, as it were.
bool has_come(const TraceState& state) { return !state.left || state.place != TraceState{}.place; }

std::uint64_t count(const PoseTrace& trace, EventKind kind) {
  return static_cast<std::uint64_t>(
      std::count_if(trace.events.begin(), trace.events.end(),
                    [kind](const TraceEvent& e) { return e.event.kind == kind; }));
}

// What traces are measured by: they grow with bodies and time.
// Includes all that is in the file: scene, programs, events.
double bytes_per_body_second(const PoseTrace& trace) {
  const double seconds = static_cast<double>(trace.end.ticks) * trace.header.step;
  const auto bodies = static_cast<double>(trace.header.bodies.size());
  return seconds * bodies > 0 ? static_cast<double>(trace.bytes.size()) / (seconds * bodies) : 0;
}

Json summary_json(const PoseTrace& trace, const std::string& path) {
  Json json;
  json["trace"] = path;
  json["title"] = trace.header.title;
  json["seed"] = trace.header.seed;
  json["bodies"] = trace.header.bodies.size();
  json["time"] = static_cast<double>(trace.end.ticks) * trace.header.step;
  json["ticks"] = trace.end.ticks;
  json["end"] = to_string(trace.end.why);
  json["message"] = trace.end.message;
  json["frames"] = trace.frames;
  json["contacts"] = count(trace, EventKind::contact_began);
  json["slept"] = count(trace, EventKind::slept);
  json["woke"] = count(trace, EventKind::woke);
  json["snapped"] = count(trace, EventKind::snapped);
  json["let_go"] = count(trace, EventKind::let_go);
  json["left"] = count(trace, EventKind::left_arena);
  json["hash"] = to_hex(trace.end.hash);
  json["bytes"] = trace.bytes.size();
  // A trace of 0 s gives 0.
  json["bytes_per_body_second"] = bytes_per_body_second(trace);
  return json;
}

std::string summary_lines(const PoseTrace& trace) {
  std::string out = line("scene", printable(trace.header.title));
  out += line("bodies", fmt::format("{}, seed {}", trace.header.bodies.size(), trace.header.seed));
  out += line("end", trace.end.message.empty()
                         ? fmt::format("{} after {:.3f} s, {} ticks", to_string(trace.end.why),
                                       static_cast<double>(trace.end.ticks) * trace.header.step,
                                       trace.end.ticks)
                         : printable(trace.end.message));
  out += line("events",
              fmt::format("{} contacts, {} slept, {} woke, {} snapped, {} let go, {} left",
                          count(trace, EventKind::contact_began), count(trace, EventKind::slept),
                          count(trace, EventKind::woke), count(trace, EventKind::snapped),
                          count(trace, EventKind::let_go), count(trace, EventKind::left_arena)));
  out += line("frames", fmt::format("{}, one every {} ticks of {} s", trace.frames,
                                    trace.header.frame_every, trace.header.step));
  out += line("size", fmt::format("{} bytes, {:.1f} for a body and second", trace.bytes.size(),
                                  bytes_per_body_second(trace)));
  return out + line("hash", to_hex(trace.end.hash));
}

Json frame_json(const PoseTrace& trace, const TraceFrame& frame) {
  Json json;
  json["time"] = static_cast<double>(frame.tick) * trace.header.step;
  json["bodies"] = Json::array();
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    // Blocks that have not come are in no list.
    if (!has_come(frame.bodies[i])) continue;
    const Pose pose = frame.bodies[i].pose();
    json["bodies"].push_back({{"name", trace.header.bodies[i].name},
                              {"at", {pose.p.x, pose.p.y, pose.p.z}},
                              {"quaternion", {pose.q.w, pose.q.x, pose.q.y, pose.q.z}},
                              {"awake", frame.bodies[i].awake},
                              {"left", frame.bodies[i].left}});
  }
  return json;
}

std::string frame_lines(const PoseTrace& trace, const TraceFrame& frame) {
  std::string out =
      line("moment", fmt::format("{:.3f} s, tick {}",
                                 static_cast<double>(frame.tick) * trace.header.step, frame.tick));
  out += structure_in_lines(structure_of(picture_bodies(trace, frame)));
  std::vector<std::size_t> shown;
  // Names may be anybody's: the column has a bound.
  std::size_t more = 0, width = 16;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    if (!has_come(frame.bodies[i])) continue;
    if (shown.size() == kMostBodiesShown) {
      ++more;
      continue;
    }
    shown.push_back(i);
    width = std::max(width, printable(trace.header.bodies[i].name).size());
  }
  width = std::min(width, kWidestName);
  for (const std::size_t i : shown) {
    const Pose pose = frame.bodies[i].pose();
    out += fmt::format("{:>{}}  {:8.4f} {:8.4f} {:8.4f}  {}\n",
                       printable(trace.header.bodies[i].name), width, pose.p.x, pose.p.y, pose.p.z,
                       frame.bodies[i].left    ? "left"
                       : frame.bodies[i].awake ? "awake"
                                               : "asleep");
  }
  if (more > 0) out += fmt::format("{:>{}}  and {} more\n", "…", width, more);
  return out;
}

int verify(const ReplayOptions& options, const PoseTrace& trace, App& app) {
  Diagnostics diagnostics;
  // The scene is the one inside the trace, with its seed, so nothing outside of it can matter.
  const auto loaded = load_scene(trace.header.files, trace.header.seed, diagnostics);
  if (!loaded) {
    app.report(diagnostics);
    return kFailed;
  }
  stop_on_signals();
  Progress progress(app);
  RunHooks hooks;
  hooks.stop = &stop_requested();
  hooks.after_step = [&](const World& world) {
    // As in cmd_simulate.cpp.
    if (world.tick() % 16 != 0) return;
    progress.show(static_cast<double>(world.tick()) / static_cast<double>(trace.end.ticks),
                  fmt::format("tick {} of {}", world.tick(), trace.end.ticks));
  };
  const TraceComparison report = verify_trace(trace, *loaded, hooks);
  progress.clear();
  if (report.interrupted) {
    app.complain(fmt::format("interrupted after {} states", report.compared));
    return kRunFailed;
  }
  if (options.json) {
    Json json = summary_json(trace, options.trace);
    json["identical"] = report.identical;
    json["compared"] = report.compared;
    json["difference"] = report.difference;
    app.print(dump(json));
  } else {
    app.print(fmt::format("{}: {}, {} states compared: {}\n", printable(options.trace),
                          printable(trace.header.title), report.compared,
                          report.identical ? green("identical", app.color_out())
                                           : red(report.difference, app.color_out())));
  }
  return report.identical ? kOk : kFailed;
}

/// As stigc render draws it.
int draw(const std::string& path, const std::string& trace_name,
         const std::shared_ptr<const PoseTrace>& trace, double time, const App& app) {
  RenderOptions picture;
  picture.file = trace_name;
  picture.output = path;
  int code = kOk;
  const auto film = pose_film(with_size(picture), trace, app, code);
  return film ? write_output(path, film->picture(time, 0), app) : code;
}

/// All poses, which may be more than fits into memory, piece by piece.
int write_poses(const std::string& path, const PoseTrace& trace, const App& app) {
  GrowingFile file;
  FileError error;
  bool good = file.open(path, error);
  if (good) {
    const auto write = path.ends_with(".mcap") ? write_pose_mcap : write_pose_csv;
    write(trace, [&](std::string_view piece) { return good = file.append(piece, error); });
  }
  if (!good || !file.commit(error)) {
    app.complain(error.message);
    return kRunFailed;
  }
  app.say("wrote " + printable(path));
  return kOk;
}

bool is_picture(const std::string& path) { return path.ends_with(".png"); }

int check_names(const ReplayOptions& options, const App& app) {
  for (const std::string& path : options.outputs) {
    if (is_picture(path) || path.ends_with(".csv") || path.ends_with(".mcap")) continue;
    app.complain(
        fmt::format("'{}': pictures of scenes are .png, tables of poses .csv, poses for viewers "
                    "of robots' data .mcap",
                    printable(path)));
    return kUsage;
  }
  return kOk;
}

}  // namespace

int replay_poses(const ReplayOptions& options, std::string bytes, App& app) {
  if (const int code = check_names(options, app); code != kOk) return code;
  Diagnostics diagnostics;
  auto read = read_pose_trace(options.trace, std::move(bytes), diagnostics);
  if (!read) {
    app.report(diagnostics);
    return kFailed;
  }
  const auto trace = std::make_shared<const PoseTrace>(std::move(*read));
  // Before anything is worked out: a name that cannot be written is said at once.
  if (const int code = check_outputs(options.outputs, app); code != kOk) return code;
  if (options.verify) return verify(options, *trace, app);
  const double end = static_cast<double>(trace->end.ticks) * trace->header.step;
  // Beyond the end is the end.
  const double at = std::min(options.at.value_or(end), end);
  const auto tick = static_cast<std::uint64_t>(std::llround(at / trace->header.step));
  const TraceFrame frame = frame_at(*trace, tick);
  if (options.json) {
    Json json = summary_json(*trace, options.trace);
    if (options.at) json["moment"] = frame_json(*trace, frame);
    app.print(dump(json));
  } else {
    app.print(summary_lines(*trace) + (options.at ? frame_lines(*trace, frame) : ""));
  }
  for (const std::string& path : options.outputs) {
    const int code = is_picture(path) ? draw(path, options.trace, trace, at, app)
                                      : write_poses(path, *trace, app);
    if (code != kOk) return code;
  }
  return kOk;
}

}  // namespace stig::cli
