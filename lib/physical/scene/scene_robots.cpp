// SPDX-License-Identifier: MIT
// Robots of a scene file, and what their sensors get wrong.
#include <fmt/format.h>

#include "base/degree.h"
#include "physical/scene/scene_parts.h"

namespace stig::physics {

namespace {

void read_params(const YamlNode& node, RobotSpawn& spawn, SceneParts& parts) {
  if (node.kind != YamlKind::mapping) {
    parts.out.add(Code::R103, parts.document.head(node), "expected a mapping of parameters");
    return;
  }
  for (const YamlPair& pair : node.pairs) {
    const YamlNode& value = pair.value;
    if (value.kind != YamlKind::scalar) {
      parts.out.add(Code::R103, parts.document.head(value),
                    "a parameter is a number, a text, or true or false");
      continue;
    }
    // Quotes make a text of anything, as in YAML.
    const bool plain = value.style == YamlStyle::plain;
    if (const auto number = number_of(value)) {
      spawn.params.emplace_back(pair.key.text, *number);
    } else if (plain && (value.text == "true" || value.text == "false")) {
      spawn.params.emplace_back(pair.key.text, value.text == "true");
    } else {
      spawn.params.emplace_back(pair.key.text, value.text);
    }
  }
}

// Rows about the entry's place; names are numbered over the whole scene.
void add_robots(const FormView& node, const RobotSpawn& spawn, SceneParts& parts) {
  const auto grid = node.numbers("grid");
  if (grid.size() != 2) return parts.scene.robots.push_back(spawn);
  const double pitch = node.number("pitch", 0.4);
  for (double y = 0; y < grid[1]; ++y) {
    for (double x = 0; x < grid[0]; ++x) {
      RobotSpawn one = spawn;
      one.X_WR.p += Vec3{x - (grid[0] - 1) / 2, y - (grid[1] - 1) / 2, 0} * pitch;
      one.name = fmt::format("{} {}", node.text("name", parts.scene.robot_models[spawn.model].name),
                             parts.scene.robots.size() + 1);
      parts.scene.robots.push_back(std::move(one));
    }
  }
}

/// `common`: the scene's program for robots whose entry names none. Of the entry's own program, the
/// common one and that of the robot's file the first that there is counts.
void read_robot_entry(const FormView& node, const YamlNode* common, SceneParts& parts) {
  RobotSpawn spawn;
  spawn.range = parts.document.head(node.node());
  const auto model = parts.files.robot_model_of(*node.find("file"));
  if (!model) return;
  spawn.model = *model;
  const RobotModel& robot = parts.scene.robot_models[*model];
  spawn.name = node.text("name", fmt::format("{} {}", robot.name, parts.scene.robots.size() + 1));
  const auto at = node.numbers("at");
  if (at.size() == 2) spawn.X_WR.p = {at[0], at[1], 0};
  spawn.X_WR.q = rotation({0, 0, node.number("heading") * kDegree});
  spawn.jitter = node.number("jitter");
  spawn.turn_jitter = node.number("turn_jitter") * kDegree;
  const YamlNode* program = node.find("program");
  if (program == nullptr) program = common;
  const std::string path = program == nullptr ? robot.program : program->text;
  if (!path.empty()) {
    spawn.program = parts.files.program_of(program == nullptr ? node.node() : *program, path);
  }
  if (const YamlNode* params = node.find("params")) {
    read_params(*params, spawn, parts);
    parts.files.add_params(spawn.program, spawn);
  }
  add_robots(node, spawn, parts);
}

}  // namespace

void read_robots(const FormView& root, SceneParts& parts) {
  for (const FormView& entry : root.forms("robots")) {
    read_robot_entry(entry, root.find("robot_program"), parts);
  }
}

void read_noise(const FormView& node, Scene& scene) {
  CameraNoise& camera = scene.camera_noise;
  camera.pixel = node.number("pixels");
  camera.missed_tags = node.number("missed_tags");
  camera.missed_leds = node.number("missed_leds");
  camera.false_tags = node.number("false_tags");
  camera.false_leds = node.number("false_leds");
  camera.colour = node.number("colour");
  camera.latency = static_cast<int>(node.number("camera_latency"));
  scene.range_noise.distance = node.number("distance");
  scene.range_noise.latency = static_cast<int>(node.number("range_latency"));
  scene.encoder_noise.count = node.number("encoder_count");
}

}  // namespace stig::physics
