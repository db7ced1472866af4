// SPDX-License-Identifier: MIT
#include "outputs.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <set>

#include "base/file_io.h"
#include "lattice/structure_files.h"
#include "report.h"

namespace stig {
namespace {

constexpr std::string_view kRun = "{run}";

/// A field of a CSV file (RFC 4180): quoted when it must be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

/// The kind of one path, and what is wrong with it in words.
std::string classify(const std::string& path, bool ensemble, Output& output) {
  output.path = path;
  if (path.ends_with(".csv")) {
    output.kind = OutputKind::deposits;
    return {};
  }
  if (path.ends_with(".stigt")) output.kind = OutputKind::trace;
  if (ensemble && output.kind == OutputKind::trace) {
    return fmt::format("'{}': a trace is of one run, not of --runs", path);
  }
  if (ensemble && path.find(kRun) == std::string::npos) {
    return fmt::format("'{}': with --runs the name needs {{run}}, or the ending .csv", path);
  }
  std::string error;
  if (output.kind == OutputKind::trace || can_write_structure(path, error)) return {};
  return error + " .csv .stigt";
}

}  // namespace

std::string folder_problem(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
    return fmt::format("cannot write '{}': it is a folder", path);
  }
  if (access(folder.c_str(), W_OK | X_OK) == 0) return {};
  return fmt::format("cannot write '{}': {}", path, strerror(errno));
}

std::string same_file_problem(const std::vector<std::optional<std::string>>& written,
                              const std::vector<std::optional<std::string>>& read) {
  namespace fs = std::filesystem;
  const auto same = [](const std::string& a, const std::string& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    const fs::path first = fs::weakly_canonical(fs::absolute(a, error), error);
    const fs::path second = fs::weakly_canonical(fs::absolute(b, error), error);
    return !error && first == second;
  };
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (!written[i] || *written[i] == "-") continue;
    for (const auto& other : read) {
      if (other && *other != "-" && same(*written[i], *other)) {
        return fmt::format("'{}' would be written over what is read", *written[i]);
      }
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (written[k] && same(*written[i], *written[k])) {
        return fmt::format("'{}' and '{}' are one file", *written[k], *written[i]);
      }
    }
  }
  return {};
}

std::string path_of_run(const std::string& path, std::uint32_t run) {
  std::string out = path;
  const std::string number = std::to_string(run);
  for (std::size_t at = out.find(kRun); at != std::string::npos;
       at = out.find(kRun, at + number.size())) {
    out.replace(at, kRun.size(), number);
  }
  return out;
}

int plan_outputs(const std::vector<std::string>& paths, const std::optional<std::string>& trace,
                 bool ensemble, const App& app, std::vector<Output>& outputs) {
  std::set<std::string> seen;
  std::vector<std::string> problems;
  const auto add = [&](const std::string& path, std::string problem, const Output& output) {
    if (problem.empty() && !seen.insert(path).second) problem = "'" + path + "' is given twice";
    if (!problem.empty()) problems.push_back(problem);
    outputs.push_back(output);
  };
  for (const std::string& path : paths) {
    Output output;
    const std::string problem = classify(path, ensemble, output);
    add(path, problem, output);
  }
  if (trace) {
    add(*trace, ensemble ? "--trace is of one run, not of --runs" : "",
        {OutputKind::trace, *trace});
  }
  for (const std::string& problem : problems) app.complain(printable(problem));
  if (!problems.empty()) return kUsage;
  for (const Output& output : outputs) {
    const std::string problem = folder_problem(output.path);
    if (problem.empty()) continue;
    app.complain(printable(problem));
    return kRunFailed;
  }
  return kOk;
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
  if (trace_) trace_->deposit(d);
  if (!log_wanted_) return;
  fmt::format_to(std::back_inserter(log_), "{},{},{},{},{},{},{},{},{}\n", ++deposits_, d.step,
                 d.site.x, d.site.y, d.site.z, csv_field(rules_.brick(d.colour).symbol),
                 d.match.rule + 1, d.match.orientation, d.agent);
}

bool OutputWriter::write_one(const Output& output, const SwarmResult& result, std::string& error) {
  const std::string path = path_of_run(output.path, config_.run);
  if (output.kind == OutputKind::structure) {
    const std::string title = rules_.title.empty() ? rules_.name : rules_.title;
    return write_structure(path, result.structure, rules_.bricks, title, rules_.floor, error);
  }
  FileError failure;
  const bool good =
      write_file(path, output.kind == OutputKind::trace ? trace_bytes_ : log_, failure);
  error = failure.message;
  return good;
}

int OutputWriter::write(const SwarmResult& result, const App& app) {
  if (trace_) trace_bytes_ = trace_->finish(result.steps, result.terminated);
  int code = kOk;
  for (const Output& output : outputs_) {
    std::string error;
    if (write_one(output, result, error)) {
      app.say("wrote " + path_of_run(output.path, config_.run));
    } else {
      app.complain(error);
      code = kRunFailed;
    }
  }
  return code;
}

bool write_structure(const std::string& path, const Structure& structure,
                     const std::vector<Brick>& bricks, const std::string& title, bool floor,
                     std::string& error) {
  StructureWriteOptions options;
  options.picture.title = printable(title);
  options.picture.floor = floor;
  return write_structure_file(path, structure, bricks, options, error);
}

}  // namespace stig
