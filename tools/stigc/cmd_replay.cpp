// SPDX-License-Identifier: MIT
// stigc replay: does a trace's run come out again, event by event? Traces of simulate are
// for pose_replay.cpp.
//
// A trace carries its rule set, start and settings, so replaying needs nothing else: it shows that
// a run was what it claims, on this machine and with this version.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "commands.h"
#include "lattice/trace.h"
#include "physical/trace/pose_trace.h"
#include "pose_replay.h"
#include "progress.h"
#include "report.h"
#include "trace_rules.h"

namespace stig::cli {
namespace {

void print(const ReplayOptions& options, const Trace& trace, const RuleSet& rules,
           const ReplayReport& report, App& app) {
  if (options.json) {
    Json json;
    json["trace"] = options.trace;
    json["ruleset"] = rules.name;
    json["ruleset_hash"] = to_hex(trace.rule_set_hash);
    json["seed"] = trace.config.seed;
    json["motion"] = to_string(trace.config.motion);
    json["events"] = trace.events.size();
    json["identical"] = report.identical;
    json["compared"] = report.compared;
    json["difference"] = report.difference;
    app.print(dump(json));
  } else if (report.identical) {
    app.print(fmt::format("{}: {}, {} events, {}\n", printable(options.trace),
                          printable(rules.name), report.compared,
                          green("identical", app.color_out())));
  } else {
    app.print(fmt::format("{}: {}, {}: {}\n", printable(options.trace), printable(rules.name),
                          red("differs", app.color_out()), printable(report.difference)));
  }
}

}  // namespace

int run(const ReplayOptions& options, App& app) {
  auto bytes = trace_bytes(options.trace, app);
  if (!bytes) return kFailed;
  // The two kinds of traces are told apart by their first bytes, as `file` would.
  if (bytes->starts_with(kPoseTraceMagic)) return replay_poses(options, std::move(*bytes), app);
  if (options.at || !options.outputs.empty()) {
    app.complain("--at and -o are for traces of stigc simulate");
    return kUsage;
  }
  Diagnostics diagnostics;
  const std::optional<Trace> trace = read_trace(options.trace, *bytes, diagnostics);
  if (!trace) {
    app.report(diagnostics);
    return kFailed;
  }
  const std::optional<RuleSet> rules = rules_of(*trace, options.trace, app);
  if (!rules) return kFailed;
  stop_on_signals();
  Progress progress(app);
  SwarmHooks hooks;
  hooks.stop = &stop_requested();
  hooks.progress = [&](std::uint64_t, std::uint64_t deposits) {
    // The number of events is known beforehand.
    const double share = static_cast<double>(deposits) / static_cast<double>(trace->events.size());
    progress.show(share, fmt::format("{} of {} events", deposits, trace->events.size()));
  };
  const ReplayReport report = replay(*trace, *rules, hooks);
  progress.clear();
  // A difference that was found before a stop is a result all the same.
  if (report.interrupted) {
    app.complain(fmt::format("interrupted after {} events", report.compared));
    return kRunFailed;
  }
  print(options, *trace, *rules, report, app);
  return report.identical ? kOk : kFailed;
}

}  // namespace stig::cli
