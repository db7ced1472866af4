// SPDX-License-Identifier: MIT
// The ending says what is written: structures by lattice/structure_files.h, and two kinds that only
// a run has, the log of deposits and the trace.
#include "explore_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>

#include "base/file_io.h"
#include "base/text.h"
#include "lattice/structure_files.h"
#include "outputs.h"
#include "report.h"

namespace stig::cli {
namespace {

constexpr std::string_view kRun = "{run}";

/// The kind of one path, and what is wrong with it in words.
std::string classify(const std::string& path, bool ensemble, Output& output) {
  output.path = path;
  const bool numbered = path.find(kRun) != std::string::npos;
  if (path.ends_with(".csv")) {
    output.kind = OutputKind::deposits;
    // The table of runs takes the place of the log.
    if (!ensemble || !numbered) return {};
    return fmt::format("'{}': with --runs .csv is one table of all runs: leave {{run}} out", path);
  }
  if (path.ends_with(".jsonl")) {
    output.kind = OutputKind::records;
    if (ensemble && !numbered) return {};
    return fmt::format("'{}': .jsonl has a record of each of --runs; {}", path,
                       ensemble ? "leave {run} out" : "--json prints that of one run");
  }
  if (path.ends_with(".stigt")) output.kind = OutputKind::trace;
  if (ensemble && output.kind == OutputKind::trace) {
    return fmt::format("'{}': a trace is of one run, not of --runs", path);
  }
  if (ensemble && !numbered) {
    return fmt::format("'{}': with --runs the name needs {{run}}, or the ending .csv or .jsonl",
                       path);
  }
  // can_write_structure lists its own endings; these two are more.
  std::string error;
  if (output.kind == OutputKind::trace || can_write_structure(path, error)) return {};
  return error + " .csv .jsonl .stigt";
}

}  // namespace

std::string path_of_run(const std::string& path, std::uint32_t run) {
  std::string out = path;
  const std::string number = std::to_string(run);
  for (std::size_t at = out.find(kRun); at != std::string::npos;
       at = out.find(kRun, at + number.size())) {
    out.replace(at, kRun.size(), number);
  }
  return out;
}

std::vector<std::string> names_of(const std::vector<Output>& outputs, int runs) {
  assert(runs >= 1);
  // Ten thousand names are enough to find what is wrong with all.
  constexpr int kMostRunsNamed = 10'000;
  std::vector<std::string> names;
  for (const Output& output : outputs) {
    const bool each = output.path.find(kRun) != std::string::npos;
    for (int run = 0; run < (each ? std::min(runs, kMostRunsNamed) : 1); ++run) {
      names.push_back(path_of_run(output.path, static_cast<std::uint32_t>(run)));
    }
  }
  return names;
}

int plan_outputs(const std::vector<std::string>& paths, const std::optional<std::string>& trace,
                 bool ensemble, const App& app, std::vector<Output>& outputs) {
  std::vector<std::string> problems;
  // All problems at once, as everywhere.
  for (const std::string& path : paths) {
    problems.push_back(classify(path, ensemble, outputs.emplace_back()));
  }
  if (trace) {
    problems.emplace_back(ensemble ? "--trace is of one run, not of --runs" : "");
    outputs.push_back({OutputKind::trace, *trace});
  }
  std::erase(problems, "");
  for (const std::string& problem : problems) app.complain(printable(problem));
  return problems.empty() ? kOk : kUsage;
}

OutputWriter::OutputWriter(const std::vector<Output>& outputs, const RuleSet& rules,
                           const SwarmConfig& config)
    : outputs_(outputs), rules_(rules), config_(config) {
  const auto any = [&](OutputKind kind) {
    return std::any_of(outputs.begin(), outputs.end(),
                       [&](const Output& output) { return output.kind == kind; });
  };
  if (any(OutputKind::trace)) trace_ = std::make_unique<TraceWriter>(rules, config);
  log_wanted_ = any(OutputKind::deposits);
  if (log_wanted_) log_ = "deposit,step,x,y,z,brick,rule,orientation,agent\n";
}

void OutputWriter::deposit(const Deposit& d) {
  assert(wants_deposits());
  if (trace_) trace_->deposit(d);
  if (!log_wanted_) return;
  // Rules count from 1, as everywhere that people read; agents from 0, and -1 is none.
  fmt::format_to(std::back_inserter(log_), "{},{},{},{},{},{},{},{},{}\n", ++deposits_, d.step,
                 d.site.x, d.site.y, d.site.z, csv_field(rules_.brick(d.colour).symbol),
                 d.match.rule + 1, d.match.orientation, d.agent);
}

bool OutputWriter::write_one(const Output& output, const SwarmResult& result, std::string& error) {
  const std::string path = path_of_run(output.path, config_.run);
  if (output.kind == OutputKind::structure) {
    const std::string title = rules_.title.empty() ? rules_.name : rules_.title;
    return write_structure(path, result.structure, rules_.bricks, title, rules_.floor, error,
                           output.palette);
  }
  FileError failure;
  const bool good =
      write_file(path, output.kind == OutputKind::trace ? trace_bytes_ : log_, failure);
  error = failure.message;
  return good;
}

int OutputWriter::write(const SwarmResult& result, const App& app) {
  // Before any file is written: a trace ends with how the run ended.
  if (trace_) trace_bytes_ = trace_->finish(result.steps, result.terminated);
  int code = kOk;
  for (const Output& output : outputs_) {
    std::string error;
    if (write_one(output, result, error)) {
      app.say("wrote " + printable(path_of_run(output.path, config_.run)));
    } else {
      app.complain(error);
      code = kRunFailed;
    }
  }
  return code;
}

}  // namespace stig::cli
