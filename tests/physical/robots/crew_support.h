// SPDX-License-Identifier: MIT
// Scenes with programs, from texts.
#pragma once

#include <map>

#include "physical/simulation/loaded_scene.h"
#include "physical/simulation/simulation.h"
#include "physical/support.h"
#include "support/uses.h"

namespace stig {

inline std::string shipped(const std::string& path) {
  FileError error;
  auto text = read_file(STIG_SOURCE_DIR "/" + path, kMaxSceneBytes, error);
  REQUIRE_MESSAGE(text, error.message);
  return *text;
}

/// A scene with the shipped block and its program, the robot of 2017, and these programs.
inline LoadedScene crew_scene(const std::string& text,
                              const std::map<std::string, std::string>& programs = {},
                              std::uint64_t seed = 1) {
  std::vector<SceneFile> files = {{"s.yaml", text},
                                  {"stigmergic.yaml", shipped("blocks/stigmergic.yaml")},
                                  {"stigmergic.lua", shipped("blocks/stigmergic.lua")},
                                  {"bebot.yaml", shipped("robots/bebot.yaml")}};
  for (const auto& [name, program] : programs) files.push_back({name, program});
  Diagnostics diagnostics;
  auto loaded = load_scene(files, seed, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(loaded);
  return std::move(*loaded);
}

/// A trace that must be good.
inline PoseTrace trace_of(const std::string& bytes) {
  Diagnostics diagnostics;
  auto trace = read_pose_trace("t.stigp", bytes, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(trace);
  return std::move(*trace);
}

/// What a run said, wrote and came to.
struct CrewRun {
  std::vector<CrewLine> lines;
  std::string trace, state;
  std::uint64_t hash = 0;
  RunTally tally;
  RunEnd end = RunEnd::duration;

  /// What one robot or block said, without failures.
  std::vector<std::string> said(const std::string& who) const {
    std::vector<std::string> out;
    for (const CrewLine& line : lines) {
      if (line.who == who && !line.failure) out.push_back(line.text);
    }
    return out;
  }
  std::vector<CrewLine> failures() const {
    std::vector<CrewLine> out;
    for (const CrewLine& line : lines) {
      if (line.failure) out.push_back(line);
    }
    return out;
  }
};

/// Goes on from `run`, whose trace `earlier` is, if there is one.
inline CrewRun recorded(Simulation& run, const LoadedScene& loaded, double duration,
                        const std::string& earlier = {}) {
  CrewRun out;
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view bytes) { out.trace += bytes; });
  if (!earlier.empty()) copy_records(trace_of(earlier), run.world().tick(), writer);
  run.record(writer);
  RunHooks hooks;
  hooks.on_line = [&](const CrewLine& line) { out.lines.push_back(line); };
  out.end = run.until(duration, hooks);
  run.finish(out.end);
  out.hash = run.hash();
  out.tally = run.tally();
  out.state = run.state();
  return out;
}

inline CrewRun recorded(const LoadedScene& loaded, double duration) {
  Simulation run(loaded.scene, loaded.placed);
  return recorded(run, loaded, duration);
}

/// Stopped at `at` seconds and brought back, a run of `whole`'s duration goes on to the same bytes.
inline void check_brought_back(const LoadedScene& loaded, double at, double duration,
                               const CrewRun& whole) {
  CAPTURE(at);
  Simulation first(loaded.scene, loaded.placed), second(loaded.scene, loaded.placed);
  const CrewRun half = recorded(first, loaded, at);
  REQUIRE(second.resume(half.state));
  const CrewRun rest = recorded(second, loaded, duration, half.trace);
  CHECK(rest.hash == whole.hash);
  CHECK(rest.state == whole.state);
  CHECK(rest.trace == whole.trace);
}

/// A run of a scene of these blocks and robots under a script.
struct Scripted {
  LoadedScene loaded;
  Simulation run;
  std::vector<std::string> said;
  RunEnd end;

  Scripted(const std::string& scene, const std::string& script, double duration,
           std::map<std::string, std::string> programs = {})
      : loaded(scripted_scene(scene, script, std::move(programs))),
        run(loaded.scene, loaded.placed) {
    RunHooks hooks;
    hooks.on_line = [this](const CrewLine& line) { said.push_back(line.text); };
    end = run.until(duration, hooks);
    run.end_script(hooks);
  }

  static LoadedScene scripted_scene(const std::string& scene, const std::string& script,
                                    std::map<std::string, std::string> programs = {}) {
    programs["e.lua"] = script;
    return crew_scene("stigc_scene: 1\nscript: e.lua\n" + scene, programs);
  }
};

/// The values of a channel of a trace, with their ticks.
inline std::vector<TraceValue> values_of(const std::string& bytes, std::string_view channel) {
  const PoseTrace trace = trace_of(bytes);
  std::vector<TraceValue> out;
  for (const TraceValue& value : trace.values) {
    if (trace.header.channels[value.channel] == channel) out.push_back(value);
  }
  return out;
}

}  // namespace stig
