// SPDX-License-Identifier: MIT
#include "view_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "outputs.h"
#include "physical/trace/pose_trace.h"
#include "structure_input.h"
#include "trace_rules.h"
#include "view/lattice_run.h"
#include "view/pose_run.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

bool add_poses(const std::string& path, std::string bytes, const App& app, PageContent& page) {
  Diagnostics diagnostics;
  const auto trace = read_pose_trace(path, std::move(bytes), diagnostics);
  app.report(diagnostics);
  if (trace) add_pose_run(*trace, file_name(path), page);
  return trace.has_value();
}

bool add_trace(const std::string& path, const App& app, PageContent& page) {
  auto bytes = trace_bytes(path, app);
  if (!bytes) return false;
  if (bytes->starts_with(kPoseTraceMagic)) return add_poses(path, std::move(*bytes), app, page);
  Diagnostics diagnostics;
  const std::optional<Trace> trace = read_trace(path, *bytes, diagnostics);
  app.report(diagnostics);
  const std::optional<RuleSet> rules = trace ? rules_of(*trace, path, app) : std::nullopt;
  if (!rules) return false;
  const auto problem = add_lattice_run(*trace, *rules, file_name(path), page);
  if (problem) app.complain(fmt::format("'{}': {}", printable(path), *problem));
  return !problem;
}

/// The traces of a folder that validate wrote, by seed.
std::vector<std::string> traces_in(const std::string& folder) {
  std::vector<std::string> out;
  std::error_code error;
  for (auto it = fs::directory_iterator(folder, error); !error && it != fs::directory_iterator();
       it.increment(error)) {
    if (it->path().extension() == ".stigp") out.push_back(it->path().string());
  }
  // run-9 before run-10.
  std::sort(out.begin(), out.end(), [](const std::string& a, const std::string& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return out;
}

/// The traces that write_witness has called so; none where there is a file of this very name.
std::vector<std::string> witness_of(const std::string& name) {
  std::vector<std::string> out;
  std::error_code ignored;
  if (fs::exists(name, ignored)) return out;
  for (const char* ending : {"-first.stigt", "-second.stigt", ".stigt"}) {
    if (fs::exists(name + ending, ignored)) out.push_back(name + ending);
  }
  return out;
}

/// Why there is nothing to see in what is no file of a run or a structure; empty: there may be.
std::string never_viewed(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    return fmt::format("there is no trace (.stigp) in the folder '{}'", path);
  }
  if (path.ends_with(".yaml") || path.ends_with(".yml")) {
    return fmt::format("'{}' is no run: record one by --trace, or look on with --live", path);
  }
  return {};
}

}  // namespace

std::vector<std::string> viewed_files(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  std::error_code ignored;
  for (const std::string& name : names) {
    std::vector<std::string> parts =
        fs::is_directory(name, ignored) ? traces_in(name) : witness_of(name);
    if (parts.empty()) parts = {name};
    out.insert(out.end(), parts.begin(), parts.end());
  }
  return out;
}

bool add_file(const std::string& path, const ViewOptions& options, const App& app,
              PageContent& page) {
  if (path.ends_with(".stigt") || path.ends_with(".stigp")) return add_trace(path, app, page);
  if (const std::string problem = never_viewed(path); !problem.empty()) {
    app.complain(printable(problem));
    return false;
  }
  const auto loaded = read_structure(path, options.lattice, app, options.mesh);
  if (loaded) add_structure(*loaded, file_name(path), page);
  return loaded.has_value();
}

bool add_target(const ViewOptions& options, const App& app, PageContent& page) {
  if (!options.target) return true;
  const auto loaded = read_structure(*options.target, options.lattice, app, options.mesh);
  if (loaded) set_target(*loaded, file_name(*options.target), page);
  return loaded.has_value();
}

}  // namespace stig::cli
