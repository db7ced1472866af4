// SPDX-License-Identifier: MIT
// From nodes to a Scene. The table of keys (scene_keys.cpp) has been checked before, so kinds and
// ranges of values hold here; what is left are questions between keys and between files: kinds of
// entries, keys without use, names of materials. Every file that is read is kept in `files`, by the
// name by which the scene calls it, so that a trace or checkpoint can run the scene again without
// any of them.
#include "base/form.h"
#include "physical/scene/scene.h"
#include "physical/scene/scene_keys.h"
#include "physical/scene/scene_parts.h"

namespace stig::physics {

namespace {

void read_script(const FormView& root, SceneParts& parts) {
  if (const YamlNode* script = root.find("script")) {
    parts.scene.script = parts.files.program_of(*script, script->text);
  }
  // Without a script too: a hand may drop some (trace/hand_action.h).
  parts.scene.stock = static_cast<std::size_t>(root.number("stock"));
  // One kind of stock for a scene: bodies that come later have no entry to ask.
  if (!parts.scene.caches.empty()) {
    parts.scene.stock_model = parts.scene.caches.front().model;
  } else if (parts.scene.stock > 0) {
    parts.scene.stock_model = parts.files.model_of(root).value_or(0);
  }
}

/// One for all blocks, or, where robots set their colours by radio, that of their file.
void read_block_programs(const FormView& root, SceneParts& parts) {
  parts.scene.block_programs.assign(parts.scene.models.size(), RobotSpawn::kNoProgram);
  const YamlNode* all = root.find("block_program");
  if (all == nullptr && parts.scene.robots.empty()) return;
  for (std::size_t i = 0; i < parts.scene.models.size(); ++i) {
    const std::string& own = parts.scene.models[i].program;
    if (all == nullptr && own.empty()) continue;
    parts.scene.block_programs[i] = all != nullptr
                                        ? parts.files.program_of(*all, all->text)
                                        : parts.files.program_of(parts.document.root, own);
  }
}

// Robots before programs of blocks: whether blocks run programs depends on there being robots.
Scene read_parts(const YamlDocument& document, const BadNodes& bad, const SceneLoader& load,
                 Diagnostics& out) {
  Scene scene;
  SceneParts parts{document, out, scene, NamedFiles(document, load, out, scene)};
  const FormView root(document.root, bad);
  scene.source = document.source;
  scene.files.push_back({document.source->path(), document.source->text()});
  scene.title = root.text("title");
  scene.seed = static_cast<std::uint64_t>(root.number("seed", 1));
  scene.duration = root.number("duration", scene.duration);
  scene.stop_asleep = root.form("stop").flag("asleep");
  scene.stop_failed = root.form("stop").flag("failed");
  if (root.text("interface") == "2019") scene.interface = InterfaceLevel::of_2019;
  read_settings(root, parts);
  read_blocks(root, parts);
  read_robots(root, parts);
  read_obstacles(root, parts);
  read_caches(root, parts);
  check_friction(root.form("friction"), parts);
  read_script(root, parts);
  read_block_programs(root, parts);
  scene.lights = root.flag("lights", true);
  read_noise(root.form("noise"), scene);
  return scene;
}

}  // namespace

std::optional<Scene> read_scene(SourceRef source, const SceneLoader& load,
                                Diagnostics& diagnostics) {
  Diagnostics own;
  std::optional<Scene> scene;
  // At most 8 levels deep and 200,000 nodes.
  const auto document = parse_yaml(std::move(source), {kMaxSceneBytes, 8, 200'000}, own);
  if (document) {
    const BadNodes bad = check_form(*document, scene_keys(), own);
    if (!own.has_errors()) scene = read_parts(*document, bad, load, own);
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : std::move(scene);
}

}  // namespace stig::physics
