// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "physical/poses_file.h"
#include "physical/scene.h"
#include "physical/scene_keys.h"

namespace stig {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 22;  ///< of blocks and poses
constexpr std::string_view kDefaultBlock = "stigmergic.yaml";

Vec3 vec3_or(const YamlNode& node, std::string_view key, const Vec3& otherwise = {}) {
  const auto v = numbers_or(node, key, {otherwise.x, otherwise.y, otherwise.z});
  return {v[0], v[1], v[2]};
}

/// Pairs of a table of friction, in the order of the materials' numbers.
constexpr std::array<std::string_view, 4> kMaterialNames = {"block", "floor", "wheel", "robot"};

void read_friction(const YamlNode& node, WorldConfig& config) {
  config.friction = number_or(node, "default", config.friction);
  for (Material a = 0; a < kMaterialNames.size(); ++a) {
    for (Material b = a; b < kMaterialNames.size(); ++b) {
      const YamlNode* value = node.find(fmt::format("{}-{}", kMaterialNames[a], kMaterialNames[b]));
      if (value == nullptr) continue;
      std::erase_if(config.frictions, [a, b](const auto& p) { return p.a == a && p.b == b; });
      config.frictions.push_back({a, b, *number_of(*value)});
    }
  }
}

void read_magnets(const YamlNode& node, WorldConfig& config) {
  config.magnet_cutoff = number_or(node, "cutoff", config.magnet_cutoff);
  config.magnet_contact = number_or(node, "contact", config.magnet_contact);
  config.relaxation.time = number_or(node, "relaxation_time", config.relaxation.time);
  config.relaxation.sweeps =
      static_cast<int>(number_or(node, "relaxation_sweeps", config.relaxation.sweeps));
}

void read_sleep(const YamlNode& node, SleepRules& sleep) {
  sleep.enabled = flag_or(node, "enabled", sleep.enabled);
  sleep.time = number_or(node, "time", sleep.time);
  sleep.speed = number_or(node, "speed", sleep.speed);
  sleep.spin = number_or(node, "spin", sleep.spin / kDegree) * kDegree;
  sleep.waking_speed = number_or(node, "waking_speed", sleep.waking_speed);
  sleep.waking_spin = number_or(node, "waking_spin", sleep.waking_spin / kDegree) * kDegree;
  sleep.waking_force = number_or(node, "waking_force", sleep.waking_force);
}

/// An entry's kinds besides a single block, and the keys that only one kind has.
struct KindKey {
  std::string_view key;
  SpawnKind kind;
};
constexpr KindKey kStructureKeys[] = {{"column", SpawnKind::column},   {"wall", SpawnKind::wall},
                                      {"pyramid", SpawnKind::pyramid}, {"grid", SpawnKind::grid},
                                      {"scatter", SpawnKind::scatter}, {"poses", SpawnKind::poses}};
constexpr KindKey kOwnKeys[] = {{"pitch", SpawnKind::grid},
                                {"jitter", SpawnKind::grid},
                                {"tumble", SpawnKind::grid},
                                {"size", SpawnKind::scatter},
                                {"turned", SpawnKind::scatter}};

class Reader {
 public:
  Reader(const YamlDocument& document, const SceneLoader& load, Diagnostics& out)
      : document_(document), load_(load), out_(out) {}

  Scene read() {
    const YamlNode& root = document_.root;
    scene_.files.push_back({document_.source->path(), document_.source->text()});
    scene_.title = text_or(root, "title", "");
    scene_.seed = static_cast<std::uint64_t>(number_or(root, "seed", 1));
    scene_.duration = number_or(root, "duration", scene_.duration);
    read_settings(root);
    if (const YamlNode* stop = root.find("stop")) {
      scene_.stop_asleep = flag_or(*stop, "asleep", false);
    }
    if (const YamlNode* magnets = root.find("magnets"))
      magnets_ = flag_or(*magnets, "enabled", true);
    if (const YamlNode* blocks = root.find("blocks")) {
      for (const YamlNode& entry : blocks->items) read_entry(entry);
    }
    return std::move(scene_);
  }

 private:
  void read_settings(const YamlNode& root) {
    WorldConfig& config = scene_.settings;
    config.step = number_or(root, "step", config.step);
    config.arena = number_or(root, "arena", config.arena);
    config.gravity = number_or(root, "gravity", config.gravity);
    config.floor = flag_or(root, "floor", config.floor);
    scene_.sweeps = static_cast<int>(number_or(root, "sweeps", 0));
    config.frictions = {{kBlockMaterial, kBlockMaterial, 0.2},
                        {kBlockMaterial, kFloorMaterial, 0.4}};
    if (const YamlNode* node = root.find("friction")) read_friction(*node, config);
    if (const YamlNode* node = root.find("magnets")) read_magnets(*node, config);
    if (const YamlNode* node = root.find("sleep")) read_sleep(*node, config.sleep);
  }

  void read_entry(const YamlNode& node) {
    BlockSpawn spawn;
    spawn.range = document_.head(node);
    spawn.kind = kind_of(node);
    check_use(node, spawn.kind);
    const auto model = model_of(node);
    if (!model) return;
    spawn.model = *model;
    spawn.name = text_or(node, "name", "");
    spawn.X_WE.p = vec3_or(node, "at");
    spawn.X_WE.q = turned(vec3_or(node, "turn"));
    spawn.colour = led_of(text_or(node, "color", "off")).value_or(Led::off);
    spawn.fixed = flag_or(node, "fixed", false);
    spawn.velocity = vec3_or(node, "velocity");
    spawn.spin = vec3_or(node, "spin") * kDegree;
    read_structure(node, spawn);
    scene_.blocks.push_back(std::move(spawn));
  }

  SpawnKind kind_of(const YamlNode& node) {
    const KindKey* first = nullptr;
    for (const KindKey& key : kStructureKeys) {
      const YamlNode* value = node.find(key.key);
      if (value == nullptr) continue;
      if (first != nullptr) {
        out_.add(Code::S606, document_.head(*value),
                 fmt::format("this entry has '{}' and '{}'", first->key, key.key));
      } else {
        first = &key;
      }
    }
    return first == nullptr ? SpawnKind::single : first->kind;
  }

  void check_use(const YamlNode& node, SpawnKind kind) {
    for (const KindKey& key : kOwnKeys) {
      const YamlNode* value = node.find(key.key);
      if (value == nullptr || key.kind == kind) continue;
      out_.add(Code::S608, document_.head(*value),
               fmt::format("'{}' has no use in this entry", key.key));
    }
  }

  void read_structure(const YamlNode& node, BlockSpawn& spawn) {
    const auto count = [&](std::string_view key) {
      return static_cast<int>(number_or(node, key, 1));
    };
    switch (spawn.kind) {
      case SpawnKind::column:
        spawn.count = {1, 1, count("column")};
        break;
      case SpawnKind::wall: {
        const auto size = numbers_or(node, "wall", {1, 1});
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
        read_scatter(node, spawn);
        break;
      case SpawnKind::poses:
        read_poses(*node.find("poses"), spawn);
        break;
      case SpawnKind::single:
        break;
    }
  }

  static void read_grid(const YamlNode& node, BlockSpawn& spawn) {
    const auto size = numbers_or(node, "grid", {1, 1, 1});
    for (std::size_t i = 0; i < 3; ++i) spawn.count[i] = static_cast<int>(size[i]);
    spawn.pitch = number_or(node, "pitch", 0);
    spawn.jitter = number_or(node, "jitter", 0);
    spawn.tumble = number_or(node, "tumble", 0) * kDegree;
  }

  void read_scatter(const YamlNode& node, BlockSpawn& spawn) {
    spawn.count = {static_cast<int>(number_or(node, "scatter", 1)), 1, 1};
    const std::string turned = text_or(node, "turned", "upright");
    spawn.turned = turned == "none"  ? ScatterTurn::none
                   : turned == "any" ? ScatterTurn::any
                                     : ScatterTurn::upright;
    spawn.size = vec3_or(node, "size");
    if (node.find("size") != nullptr) return;
    out_.add(Code::R102, document_.head(node), "the key 'size' is missing beside 'scatter'");
  }

  void read_poses(const YamlNode& node, BlockSpawn& spawn) {
    if (auto source = load(node, node.text)) {
      if (auto poses = read_poses_file(std::move(source), out_)) spawn.poses = std::move(*poses);
    }
  }

  /// The number of the entry's block among the models; each file is read once.
  std::optional<std::size_t> model_of(const YamlNode& node) {
    const YamlNode* key = node.find("file");
    const std::string name = key == nullptr ? std::string(kDefaultBlock) : key->text;
    for (const auto& [known, model] : models_) {
      if (known == name) return model;
    }
    std::optional<std::size_t> model;
    if (auto source = load(key == nullptr ? node : *key, name)) {
      if (auto block = read_block(std::move(source), out_)) {
        if (!magnets_) block->magnet_offset = 0;
        model = scene_.models.size();
        scene_.models.push_back(std::move(*block));
      }
    }
    models_.emplace_back(name, model);
    return model;
  }

  SourceRef load(const YamlNode& node, const std::string& name) {
    FileError error;
    auto text = load_(name, kMaxFileBytes, error);
    if (!text) {
      out_.add(error.too_large ? Code::R002 : Code::R001, document_.head(node), error.message);
      return nullptr;
    }
    scene_.files.push_back({name, *text});
    return std::make_shared<const SourceFile>(name, std::move(*text));
  }

  const YamlDocument& document_;
  const SceneLoader& load_;
  Diagnostics& out_;
  Scene scene_;
  bool magnets_ = true;
  std::vector<std::pair<std::string, std::optional<std::size_t>>> models_;
};

}  // namespace

SceneLoader disk_loader(std::string scene_folder, std::vector<std::string> folders) {
  folders.insert(folders.begin(), std::move(scene_folder));
  return [folders](const std::string& name, std::size_t most, FileError& error) {
    const auto path_in = [&name](const std::string& folder) {
      return (std::filesystem::path(folder) / name).string();
    };
    std::error_code ignored;
    for (const std::string& folder : folders) {
      if (std::filesystem::exists(path_in(folder), ignored)) {
        return read_file(path_in(folder), most, error);
      }
    }
    return read_file(path_in(folders.front()), most, error);
  };
}

SceneLoader memory_loader(std::vector<SceneFile> files) {
  return [files = std::move(files)](const std::string& name, std::size_t,
                                    FileError& error) -> std::optional<std::string> {
    for (const SceneFile& file : files) {
      if (file.name == name) return file.text;
    }
    error.message = fmt::format("{} is not there", in_quotes(name));
    return std::nullopt;
  };
}

std::optional<Scene> read_scene(SourceRef source, const SceneLoader& load,
                                Diagnostics& diagnostics) {
  Diagnostics own;
  std::optional<Scene> scene;
  const auto document = parse_yaml(std::move(source), {kMaxSceneBytes, 8, 200'000}, own);
  if (document && check_shape(*document, document->root, scene_keys(), own) && !own.has_errors()) {
    scene = Reader(*document, load, own).read();
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : std::move(scene);
}

std::optional<Scene> read_scene_file(const std::string& path,
                                     const std::vector<std::string>& folders,
                                     Diagnostics& diagnostics) {
  FileError error;
  auto bytes = read_file(path, kMaxSceneBytes, error);
  auto source = std::make_shared<const SourceFile>(path, bytes ? std::move(*bytes) : "");
  if (bytes) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return read_scene(std::move(source), disk_loader(folder, folders), diagnostics);
  }
  diagnostics.add(error.too_large ? Code::R002 : Code::R001, {std::move(source), 0, 0},
                  error.message);
  return std::nullopt;
}

}  // namespace stig
