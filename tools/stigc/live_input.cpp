// SPDX-License-Identifier: MIT
// A loader that listens tells which files a scene asks for, those too that it does not find; where
// they are is what the loader would take.
#include "live_input.h"

#include <filesystem>

#include "base/load.h"
#include "explore_config.h"
#include "live/lattice_live.h"
#include "live/pose_live.h"
#include "outputs.h"
#include "physical/scene/scene_programs.h"
#include "rules/rule_reader.h"
#include "scene_input.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

/// The file that a scene's name leads to, or would be looked for first.
std::string place_of(const std::string& name, const std::vector<std::string>& folders) {
  std::error_code ignored;
  for (const std::string& folder : folders) {
    std::string path = (fs::path(folder) / name).string();
    if (fs::exists(path, ignored)) return path;
  }
  return (fs::path(folders.front()) / name).string();
}

std::unique_ptr<LiveRun> live_scene(const SourceRef& source, const ViewOptions& options,
                                    std::vector<std::string>& files, Diagnostics& diagnostics) {
  const std::vector<std::string> folders = scene_folders(options.files[0]);
  const SceneLoader load = scene_loader(options.files[0]);
  const SceneLoader listening = [&](const std::string& name, std::size_t most, FileError& error) {
    files.push_back(place_of(name, folders));
    return load(name, most, error);
  };
  auto scene = read_scene(source, listening, diagnostics);
  if (!scene) return nullptr;
  auto placed = place_scene(*scene, options.seed.value_or(scene->seed), diagnostics);
  if (!placed) return nullptr;
  check_programs(*scene, *placed, diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  return pose_live(LoadedScene{std::move(*scene), std::move(*placed)});
}

std::unique_ptr<LiveRun> live_rules(const SourceRef& source, const ViewOptions& options,
                                    std::string& problem, Diagnostics& diagnostics) {
  auto rules = read_rule_set(source, diagnostics);
  if (!rules || diagnostics.has_errors()) return nullptr;
  ExploreOptions explore;
  explore.file = options.files[0];
  explore.seed = options.seed.value_or(1);
  const ExploreConfig config = explore_config(*rules, RuleTable(*rules), explore);
  problem = config.problem;
  if (!problem.empty()) return nullptr;
  return lattice_live(std::move(*rules), config.swarm, file_name(options.files[0]));
}

}  // namespace

LiveLoad load_live(const ViewOptions& options, const App& app) {
  LiveLoad out;
  out.files = options.files;
  Diagnostics diagnostics;
  std::string problem;
  if (const SourceRef source = load_source(options.files[0], kMaxSceneBytes, diagnostics)) {
    const bool scene = content_of(source->text()) == FileContent::scene;
    out.run = scene ? live_scene(source, options, out.files, diagnostics)
                    : live_rules(source, options, problem, diagnostics);
  }
  app.report(diagnostics);
  if (app.invalid(diagnostics)) out.run = nullptr;
  if (!problem.empty()) app.complain(printable(problem));
  out.trouble = problem.empty() ? to_text(diagnostics) : problem + "\n";
  return out;
}

}  // namespace stig::cli
