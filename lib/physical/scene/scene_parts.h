// SPDX-License-Identifier: MIT
// What the readers of a scene file's parts share. Private to this folder.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/form.h"
#include "lua/module_search.h"
#include "physical/scene/scene.h"
#include "physical/scene/uses.h"

namespace stig::physics {

/// The files that a scene names, each read once; what is wrong with one is said where it is named.
class NamedFiles {
 public:
  NamedFiles(const YamlDocument& document, const SceneLoader& load, Diagnostics& out, Scene& scene)
      : document_(document), load_(load), out_(out), scene_(scene) {}

  /// The text, or null after an error.
  SourceRef load(const YamlNode& node, const std::string& name);
  /// The number of an entry's block among Scene::models.
  std::optional<std::size_t> model_of(const FormView& node);
  /// Among Scene::robot_models.
  std::optional<std::size_t> robot_model_of(const YamlNode& key);
  /// For files that those of the scene name: relative to `from`, kept like all others.
  FileLoader loader_from(const std::string& from);
  /// Among Scene::programs; RobotSpawn::kNoProgram after an error.
  std::size_t program_of(const YamlNode& node, const std::string& name);
  /// Brings the modules that a robot's parameters name, of programs of 2019.
  void add_params(std::size_t program, const RobotSpawn& spawn);

 private:
  void keep(const std::string& name, const std::string& text);
  void add_modules(LuaProgram& program, const std::string& text);
  void add_searched(LuaProgram& program, WrittenModules& written);
  std::optional<std::string> module_text(const std::string& path);

  const YamlDocument& document_;
  const SceneLoader& load_;
  Diagnostics& out_;
  Scene& scene_;
  std::vector<std::pair<std::string, std::optional<std::size_t>>> models_, robot_models_;
  std::vector<WrittenModules> written_;  ///< of each of Scene::programs
};

struct SceneParts {
  const YamlDocument& document;
  Diagnostics& out;
  Scene& scene;
  NamedFiles files;
};

/// Settings of the world, friction among them, whose materials are checked when robots are known.
void read_settings(const FormView& root, SceneParts& parts);
void check_friction(const FormView& table, const SceneParts& parts);
void read_blocks(const FormView& root, SceneParts& parts);
void read_obstacles(const FormView& root, SceneParts& parts);
void read_caches(const FormView& root, SceneParts& parts);
void read_robots(const FormView& root, SceneParts& parts);
void read_noise(const FormView& node, Scene& scene);

}  // namespace stig::physics
