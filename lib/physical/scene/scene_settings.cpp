// SPDX-License-Identifier: MIT
// The settings of a scene's world.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/text.h"
#include "physical/dynamics/world_settings.h"
#include "physical/scene/scene_parts.h"

namespace stig::physics {

namespace {

/// The number of a material; a name seen for the first time gets the next, so the same file gives
/// the same numbers.
Material material_of(const std::string& name, std::vector<std::string>& names) {
  const auto known = std::find(names.begin(), names.end(), name);
  const auto number = static_cast<Material>(known - names.begin());
  if (known == names.end()) names.push_back(name);
  return number;
}

void read_friction_pairs(const FormView& table, Scene& scene) {
  WorldConfig& config = scene.settings;
  for (const FormView& pair : table.forms("pairs")) {
    const auto of = pair.names("of");
    if (scene.materials.size() > 250) return;  // of 256 there can be
    const Material a = material_of(of[0], scene.materials), b = material_of(of[1], scene.materials);
    // A pair that is listed again replaces the default, whichever way round it is written.
    std::erase_if(config.frictions, [a, b](const FrictionPair& p) {
      return (p.a == a && p.b == b) || (p.a == b && p.b == a);
    });
    config.frictions.push_back({a, b, pair.number("is")});
  }
}

void read_value(const FormView& view, const Setting& setting, auto& value) {
  using Value = std::remove_cvref_t<decltype(value)>;
  if (!view.has(setting.key)) return;
  if constexpr (std::is_enum_v<Value>) {
    const auto& words = setting.words;
    const auto word = std::find(words.begin(), words.end(), view.text(setting.key));
    value = static_cast<Value>(word - words.begin());
  } else {
    value = static_cast<Value>(view.number(setting.key) * setting.unit);
  }
}
void read_value(const FormView& view, const Setting& setting, bool& value) {
  value = view.flag(setting.key, value);
}
/// Their materials take more: see read_friction_pairs.
void read_value(const FormView& /*view*/, const Setting& /*setting*/,
                std::vector<FrictionPair>& /*pairs*/) {}

}  // namespace

void read_settings(const FormView& root, SceneParts& parts) {
  WorldConfig& config = parts.scene.settings;
  // The paper's coefficients; files of blocks say others only to the compiler.
  config.frictions = {{kBlockMaterial, kBlockMaterial, 0.2}, {kBlockMaterial, kFloorMaterial, 0.4}};
  visit_settings(
      [&root](const Setting& setting, auto& value) {
        read_value(setting.group.empty() ? root : root.form(setting.group), setting, value);
      },
      config);
  read_friction_pairs(root.form("friction"), parts.scene);
  parts.scene.magnets = root.form("magnets").flag("enabled", true);
}

/// Names of materials that nothing in the scene is made of are slips.
void check_friction(const FormView& table, const SceneParts& parts) {
  // Materials that robots of the scene do not have are still known names.
  std::set<std::string_view> made{"block", "floor", "robot", "wheel", "caster", "obstacle"};
  for (const RobotModel& robot : parts.scene.robot_models) {
    for (const BodyModel& body : robot.bodies) made.insert(body.material);
  }
  for (const ObstacleSpawn& obstacle : parts.scene.obstacles) {
    made.insert(obstacle.bodies.front().material);
  }
  const std::vector<std::string_view> known(made.begin(), made.end());
  // By set: the order of the two does not matter.
  std::map<std::set<std::string>, FormView> pairs;
  for (const FormView& pair : table.forms("pairs")) {
    const YamlNode* of = pair.find("of");
    const auto names = pair.names("of");
    const auto [first, fresh] = pairs.emplace(std::set(names.begin(), names.end()), pair);
    if (!fresh && first->second.number("is") != pair.number("is")) {
      parts.out
          .add(Code::S609, parts.document.head(pair.node()),
               "this pair of materials has another friction already")
          .note(parts.document.head(first->second.node()), "it is given here");
    }
    for (const std::string& name : pair.names("of")) {
      if (made.contains(name)) continue;
      const std::string_view near = nearest(name, known);
      parts.out.add(Code::S609, parts.document.head(of == nullptr ? pair.node() : *of),
                    fmt::format("nothing is made of {}: materials are {}{}", in_quotes(name),
                                fmt::join(known, ", "),
                                near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
    }
  }
}

}  // namespace stig::physics
