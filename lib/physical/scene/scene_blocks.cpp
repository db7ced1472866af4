// SPDX-License-Identifier: MIT
// Blocks of a scene file: single ones, structures, and caches.
#include <fmt/format.h>

#include "base/degree.h"
#include "physical/scene/poses_file.h"
#include "physical/scene/scene_parts.h"

namespace stig::physics {

namespace {

/// An entry's kinds besides a single block, and the keys that only one kind has.
struct KindKey {
  std::string_view key;
  SpawnKind kind;
};
// Keys that say what an entry is; at most one of them may be there.
constexpr KindKey kStructureKeys[] = {{"column", SpawnKind::column},   {"wall", SpawnKind::wall},
                                      {"pyramid", SpawnKind::pyramid}, {"grid", SpawnKind::grid},
                                      {"scatter", SpawnKind::scatter}, {"poses", SpawnKind::poses}};
constexpr KindKey kOwnKeys[] = {{"pitch", SpawnKind::grid},
                                {"jitter", SpawnKind::grid},
                                {"tumble", SpawnKind::grid},
                                {"size", SpawnKind::scatter},
                                {"turned", SpawnKind::scatter}};

SpawnKind kind_of(const FormView& node, SceneParts& parts) {
  const KindKey* first = nullptr;
  for (const KindKey& key : kStructureKeys) {
    const YamlNode* value = node.find(key.key);
    if (value == nullptr) continue;
    if (first != nullptr) {
      parts.out.add(Code::S606, parts.document.head(*value),
                    fmt::format("this entry has '{}' and '{}'", first->key, key.key));
    } else {
      first = &key;
    }
  }
  return first == nullptr ? SpawnKind::single : first->kind;
}

/// Keys of another kind would be ignored, which nobody means.
void check_use(const FormView& node, SpawnKind kind, SceneParts& parts) {
  for (const KindKey& key : kOwnKeys) {
    const YamlNode* value = node.find(key.key);
    if (value == nullptr || key.kind == kind) continue;
    parts.out.add(Code::S608, parts.document.head(*value),
                  fmt::format("'{}' has no use in this entry", key.key));
  }
}

void read_grid(const FormView& node, BlockSpawn& spawn) {
  const auto size = node.numbers("grid");
  for (std::size_t i = 0; i < 3; ++i) spawn.count[i] = static_cast<int>(size[i]);
  spawn.pitch = node.number("pitch");
  spawn.jitter = node.number("jitter");
  spawn.tumble = node.number("tumble") * kDegree;
}

void read_scatter(const FormView& node, BlockSpawn& spawn, SceneParts& parts) {
  spawn.count = {static_cast<int>(node.number("scatter")), 1, 1};
  const std::string turned = node.text("turned", "upright");
  spawn.turned = turned == "none"  ? ScatterTurn::none
                 : turned == "any" ? ScatterTurn::any
                                   : ScatterTurn::upright;
  spawn.size = node.vector("size");
  if (node.has("size")) return;
  parts.out.add(Code::R102, parts.document.head(node.node()),
                "the key 'size' is missing beside 'scatter'");
}

void read_poses(const YamlNode& node, BlockSpawn& spawn, SceneParts& parts) {
  if (auto source = parts.files.load(node, node.text)) {
    if (auto poses = read_poses_file(std::move(source), parts.out)) spawn.poses = std::move(*poses);
  }
}

/// What the entry's kind counts in: bricks up, along and across, or a file of poses.
void read_structure(const FormView& node, BlockSpawn& spawn, SceneParts& parts) {
  const auto count = [&](std::string_view key) { return static_cast<int>(node.number(key, 1)); };
  switch (spawn.kind) {
    case SpawnKind::column:
      spawn.count = {1, 1, count("column")};
      break;
    case SpawnKind::wall: {
      const auto size = node.numbers("wall");
      spawn.count = {static_cast<int>(size[0]), 1, static_cast<int>(size[1])};
      break;
    }
    case SpawnKind::pyramid:
      spawn.count = {1, 1, count("pyramid")};
      break;
    case SpawnKind::grid:
      read_grid(node, spawn);
      break;
    case SpawnKind::scatter:
      read_scatter(node, spawn, parts);
      break;
    case SpawnKind::poses:
      read_poses(*node.find("poses"), spawn, parts);
      break;
    case SpawnKind::single:
      break;
  }
}

void read_entry(const FormView& node, SceneParts& parts) {
  BlockSpawn spawn;
  spawn.range = parts.document.head(node.node());
  spawn.kind = kind_of(node, parts);
  check_use(node, spawn.kind, parts);
  const auto model = parts.files.model_of(node);
  if (!model) return;
  spawn.model = *model;
  spawn.name = node.text("name");
  spawn.X_WE.p = node.vector("at");
  spawn.X_WE.q = turned(node.vector("turn"));
  spawn.colour = led_of(node.text("color", "off")).value_or(Led::off);
  spawn.fixed = node.flag("fixed", false);
  spawn.velocity = node.vector("velocity");
  spawn.spin = node.vector("spin") * kDegree;
  read_structure(node, spawn, parts);
  // Only now that `fixed` is known.
  for (const char* key : {"velocity", "spin"}) {
    const YamlNode* value = node.find(key);
    if (!spawn.fixed || value == nullptr) continue;
    parts.out.add(Code::S608, parts.document.head(*value),
                  fmt::format("'{}' has no use: the block is fixed", key));
  }
  parts.scene.blocks.push_back(std::move(spawn));
}

void read_cache(const FormView& node, SceneParts& parts) {
  CacheSpawn cache;
  cache.range = parts.document.head(node.node());
  const auto model = parts.files.model_of(node);
  if (!model) return;
  cache.model = *model;
  const double side = parts.scene.models[*model].side;
  if (!parts.scene.caches.empty() && parts.scene.caches.front().model != cache.model) {
    parts.out.add(Code::S609, cache.range, "all caches of a scene have the same kind of block");
  }
  cache.at = node.vector("at", {0, 0, side / 2});
  cache.radius = node.number("radius", cache.radius);
  cache.yaw = node.number("yaw") * kDegree;
  cache.jitter = node.number("jitter");
  cache.turn_jitter = node.number("turn_jitter") * kDegree;
  cache.stock = static_cast<std::size_t>(node.number("stock", 100));
  parts.scene.caches.push_back(cache);
}

}  // namespace

void read_blocks(const FormView& root, SceneParts& parts) {
  for (const FormView& entry : root.forms("blocks")) read_entry(entry, parts);
}

void read_caches(const FormView& root, SceneParts& parts) {
  for (const FormView& entry : root.forms("caches")) read_cache(entry, parts);
}

}  // namespace stig::physics
