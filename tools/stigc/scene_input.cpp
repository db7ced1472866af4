// SPDX-License-Identifier: MIT
// Where files of a scene are: beside it, in the folders next to its own, and last where the
// program's are. A user's file so hides one of the same name that ships.
#include "scene_input.h"

#include <filesystem>

#include "base/load.h"
#include "physical/scene/scene_programs.h"
#include "shipped_files.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSceneFolders[] = {"blocks", "robots", "programs"};

void add_own_folders(const char* kind, std::vector<std::string>& out) {
  for (std::string& folder : shipped_folders(kind)) out.push_back(std::move(folder));
}

}  // namespace

FileContent content_of(std::string_view text) {
  const auto has_key = [text](std::string_view key) {
    for (std::size_t at = text.find(key); at != std::string_view::npos;
         at = text.find(key, at + 1)) {
      if (at == 0 || text[at - 1] == '\n') return true;
    }
    return false;
  };
  // The key that gives the format's version is the only one that all files of a kind have.
  if (has_key("stigc_scene:")) return FileContent::scene;
  if (has_key("stigc_robot:")) return FileContent::robot;
  if (has_key("stigc_solid:")) return FileContent::solid;
  return has_key("stigc_block:") ? FileContent::block : FileContent::rules;
}

std::vector<std::string> scene_folders(const std::string& scene_path) {
  const fs::path folder = fs::path(scene_path).parent_path();
  std::vector<std::string> out{folder.string()};
  for (const char* kind : kSceneFolders) {
    out.push_back((folder / ".." / kind).string());
    add_own_folders(kind, out);
  }
  return out;
}

SceneLoader scene_loader(const std::string& scene_path) {
  std::vector<std::string> folders = scene_folders(scene_path);
  const std::string first = folders.front();
  return disk_loader(first, {folders.begin() + 1, folders.end()});
}

SceneLoader own_loader() {
  std::vector<std::string> folders;
  for (const char* kind : kSceneFolders) add_own_folders(kind, folders);
  // A program that does not find its own files knows none.
  if (folders.empty()) return memory_loader({});
  const std::string first = folders.front();
  return disk_loader(first, std::move(folders));
}

std::optional<LoadedScene> read_loaded_scene(const std::string& path,
                                             std::optional<std::uint64_t> seed, const App& app) {
  Diagnostics diagnostics;
  std::optional<LoadedScene> loaded;
  if (SourceRef source = load_source(path, kMaxSceneBytes, diagnostics)) {
    if (auto scene = read_scene(std::move(source), scene_loader(path), diagnostics)) {
      // The seed of the command line goes before the scene's.
      if (auto placed = place_scene(*scene, seed.value_or(scene->seed), diagnostics)) {
        // Programs are tried before a long run, not in the middle of it.
        check_programs(*scene, *placed, diagnostics);
        loaded = LoadedScene{std::move(*scene), std::move(*placed)};
      }
    }
  }
  app.report(diagnostics);
  if (app.invalid(diagnostics)) loaded.reset();
  return loaded;
}

}  // namespace stig::cli
