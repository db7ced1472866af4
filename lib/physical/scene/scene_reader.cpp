// SPDX-License-Identifier: MIT
// From nodes to a Scene. The table of keys (scene_keys.cpp) has been checked before, so kinds and
// ranges of values hold here; what is left are questions between keys and between files: kinds of
// entries, keys without use, names of materials. Every file that is read is kept in `files`, by the
// name by which the scene calls it, so that a trace or checkpoint can run the scene again without
// any of them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/degree.h"
#include "base/text.h"
#include "physical/scene/poses_file.h"
#include "physical/scene/scene.h"
#include "physical/scene/scene_keys.h"
#include "robots/robot_reader.h"

namespace stig {

namespace {

// A pose file of the largest scene has about 2 MiB.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 22;  ///< of blocks and poses
constexpr std::size_t kMostModules = 64;                     ///< of one program
constexpr std::string_view kDefaultBlock = "stigmergic.yaml";

// Numbers follow the first mention, so the same file gives the same numbers.
/// The number of a material; a name seen for the first time gets the next.
Material material_of(const std::string& name, std::vector<std::string>& names) {
  const auto known = std::find(names.begin(), names.end(), name);
  const auto number = static_cast<Material>(known - names.begin());
  if (known == names.end()) names.push_back(name);
  return number;
}

void read_friction(const FormView& table, Scene& scene) {
  WorldConfig& config = scene.settings;
  config.friction = table.number("default", config.friction);
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

/// Names of materials that nothing in the scene is made of are slips.
void check_friction(const FormView& table, const Scene& scene, const YamlDocument& document,
                    Diagnostics& out) {
  // Materials that robots of the scene do not have are still known names.
  std::set<std::string_view> made{"block", "floor", "robot", "wheel", "caster"};
  for (const RobotModel& robot : scene.robot_models) {
    for (const BodyModel& body : robot.bodies) made.insert(body.material);
  }
  const std::vector<std::string_view> known(made.begin(), made.end());
  std::map<std::set<std::string>, FormView> pairs;
  // By set: the order of the two does not matter.
  for (const FormView& pair : table.forms("pairs")) {
    const YamlNode* of = pair.find("of");
    const auto names = pair.names("of");
    const auto [first, fresh] = pairs.emplace(std::set(names.begin(), names.end()), pair);
    if (!fresh && first->second.number("is") != pair.number("is")) {
      out.add(Code::S609, document.head(pair.node()),
              "this pair of materials has another friction already")
          .note(document.head(first->second.node()), "it is given here");
    }
    for (const std::string& name : pair.names("of")) {
      if (made.contains(name)) continue;
      const std::string_view near = nearest(name, known);
      out.add(Code::S609, document.head(of == nullptr ? pair.node() : *of),
              fmt::format("nothing is made of {}: materials are {}{}", in_quotes(name),
                          fmt::join(known, ", "),
                          near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
    }
  }
}

void read_magnets(const FormView& node, WorldConfig& config) {
  config.magnet_cutoff = node.number("cutoff", config.magnet_cutoff);
  config.magnet_contact = node.number("contact", config.magnet_contact);
  config.relaxation.time = node.number("relaxation_time", config.relaxation.time);
  config.relaxation.sweeps =
      static_cast<int>(node.number("relaxation_sweeps", config.relaxation.sweeps));
}

void read_sleep(const FormView& node, SleepRules& sleep) {
  sleep.enabled = node.flag("enabled", sleep.enabled);
  sleep.time = node.number("time", sleep.time);
  sleep.speed = node.number("speed", sleep.speed);
  if (node.has("spin")) sleep.spin = node.number("spin") * kDegree;
  sleep.waking_speed = node.number("waking_speed", sleep.waking_speed);
  if (node.has("waking_spin")) sleep.waking_spin = node.number("waking_spin") * kDegree;
  sleep.waking_force = node.number("waking_force", sleep.waking_force);
}

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

class Reader {
 public:
  Reader(const YamlDocument& document, const BadNodes& bad, const SceneLoader& load,
         Diagnostics& out)
      : document_(document), bad_(bad), load_(load), out_(out) {}

  // Robots before programs of blocks: whether blocks run programs depends on there being robots.
  Scene read() {
    const FormView root(document_.root, bad_);
    scene_.source = document_.source;
    scene_.files.push_back({document_.source->path(), document_.source->text()});
    scene_.title = root.text("title");
    scene_.seed = static_cast<std::uint64_t>(root.number("seed", 1));
    scene_.duration = root.number("duration", scene_.duration);
    scene_.stop_asleep = root.form("stop").flag("asleep");
    scene_.stop_failed = root.form("stop").flag("failed");
    read_settings(root);
    for (const FormView& entry : root.forms("blocks")) read_entry(entry);
    for (const FormView& entry : root.forms("robots")) {
      read_robot_entry(entry, root.find("robot_program"));
    }
    for (const FormView& entry : root.forms("caches")) read_cache(entry);
    check_friction(root.form("friction"), scene_, document_, out_);
    read_script(root);
    read_block_programs(root);
    scene_.lights = root.flag("lights", true);
    read_noise(root.form("noise"));
    return std::move(scene_);
  }

 private:
  void read_settings(const FormView& root) {
    WorldConfig& config = scene_.settings;
    config.step = root.number("step", config.step);
    config.arena = root.number("arena", config.arena);
    config.gravity = root.number("gravity", config.gravity);
    config.floor = root.flag("floor", config.floor);
    if (root.text("solver", "fast") == "stock") config.solver = SolverKind::stock;
    scene_.sweeps = static_cast<int>(root.number("sweeps"));
    // The paper's coefficients; files of blocks say others only to the compiler.
    config.frictions = {{kBlockMaterial, kBlockMaterial, 0.2},
                        {kBlockMaterial, kFloorMaterial, 0.4}};
    read_friction(root.form("friction"), scene_);
    read_magnets(root.form("magnets"), config);
    magnets_ = root.form("magnets").flag("enabled", true);
    read_sleep(root.form("sleep"), config.sleep);
  }

  void read_script(const FormView& root) {
    if (const YamlNode* script = root.find("script")) {
      scene_.script = program_of(*script, script->text);
      scene_.stock = static_cast<std::size_t>(root.number("stock"));
    }
    // One kind of stock for a scene: bodies that come later have no entry to ask.
    if (!scene_.caches.empty()) {
      scene_.stock_model = scene_.caches.front().model;
    } else if (scene_.stock > 0) {
      scene_.stock_model = model_of(root).value_or(0);
    }
  }

  /// One for all blocks, or, where robots set their colours by radio, that of their file.
  void read_block_programs(const FormView& root) {
    scene_.block_programs.assign(scene_.models.size(), RobotSpawn::kNoProgram);
    const YamlNode* all = root.find("block_program");
    if (all == nullptr && scene_.robots.empty()) return;
    for (std::size_t i = 0; i < scene_.models.size(); ++i) {
      const std::string& own = scene_.models[i].program;
      if (all == nullptr && own.empty()) continue;
      scene_.block_programs[i] =
          all != nullptr ? program_of(*all, all->text) : program_of(document_.root, own);
    }
  }

  void read_entry(const FormView& node) {
    BlockSpawn spawn;
    spawn.range = document_.head(node.node());
    spawn.kind = kind_of(node);
    check_use(node, spawn.kind);
    const auto model = model_of(node);
    if (!model) return;
    spawn.model = *model;
    spawn.name = node.text("name");
    spawn.X_WE.p = node.vector("at");
    spawn.X_WE.q = turned(node.vector("turn"));
    spawn.colour = led_of(node.text("color", "off")).value_or(Led::off);
    spawn.fixed = node.flag("fixed", false);
    spawn.velocity = node.vector("velocity");
    spawn.spin = node.vector("spin") * kDegree;
    read_structure(node, spawn);
    // Only now that `fixed` is known.
    for (const char* key : {"velocity", "spin"}) {
      const YamlNode* value = node.find(key);
      if (!spawn.fixed || value == nullptr) continue;
      out_.add(Code::S608, document_.head(*value),
               fmt::format("'{}' has no use: the block is fixed", key));
    }
    scene_.blocks.push_back(std::move(spawn));
  }

  SpawnKind kind_of(const FormView& node) {
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

  void check_use(const FormView& node, SpawnKind kind) {
    for (const KindKey& key : kOwnKeys) {
      const YamlNode* value = node.find(key.key);
      if (value == nullptr || key.kind == kind) continue;
      out_.add(Code::S608, document_.head(*value),
               fmt::format("'{}' has no use in this entry", key.key));
    }
  }

  void read_structure(const FormView& node, BlockSpawn& spawn) {
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
        read_scatter(node, spawn);
        break;
      case SpawnKind::poses:
        read_poses(*node.find("poses"), spawn);
        break;
      case SpawnKind::single:
        break;
    }
  }

  static void read_grid(const FormView& node, BlockSpawn& spawn) {
    const auto size = node.numbers("grid");
    for (std::size_t i = 0; i < 3; ++i) spawn.count[i] = static_cast<int>(size[i]);
    spawn.pitch = node.number("pitch");
    spawn.jitter = node.number("jitter");
    spawn.tumble = node.number("tumble") * kDegree;
  }

  void read_scatter(const FormView& node, BlockSpawn& spawn) {
    spawn.count = {static_cast<int>(node.number("scatter")), 1, 1};
    const std::string turned = node.text("turned", "upright");
    spawn.turned = turned == "none"  ? ScatterTurn::none
                   : turned == "any" ? ScatterTurn::any
                                     : ScatterTurn::upright;
    spawn.size = node.vector("size");
    if (node.has("size")) return;
    out_.add(Code::R102, document_.head(node.node()), "the key 'size' is missing beside 'scatter'");
  }

  void read_poses(const YamlNode& node, BlockSpawn& spawn) {
    if (auto source = load(node, node.text)) {
      if (auto poses = read_poses_file(std::move(source), out_)) spawn.poses = std::move(*poses);
    }
  }

  /// `common`: the program of robots whose entry names none, before that of their file.
  // An entry's own program, the scene's, the robot file's: the first that there is.
  void read_robot_entry(const FormView& node, const YamlNode* common) {
    RobotSpawn spawn;
    spawn.range = document_.head(node.node());
    const auto model = robot_model_of(*node.find("file"));
    if (!model) return;
    spawn.model = *model;
    const RobotModel& robot = scene_.robot_models[*model];
    spawn.name = node.text("name", fmt::format("{} {}", robot.name, scene_.robots.size() + 1));
    const auto at = node.numbers("at");
    if (at.size() == 2) spawn.X_WR.p = {at[0], at[1], 0};
    spawn.X_WR.q = rotation({0, 0, node.number("heading") * kDegree});
    spawn.jitter = node.number("jitter");
    spawn.turn_jitter = node.number("turn_jitter") * kDegree;
    const YamlNode* program = node.find("program");
    if (program == nullptr) program = common;
    const std::string path = program == nullptr ? robot.program : program->text;
    if (!path.empty()) {
      spawn.program = program_of(program == nullptr ? node.node() : *program, path);
    }
    if (const YamlNode* params = node.find("params")) read_params(*params, spawn);
    add_robots(node, spawn);
  }

  // Rows about the entry's place; names are numbered over the whole scene.
  void add_robots(const FormView& node, const RobotSpawn& spawn) {
    const auto grid = node.numbers("grid");
    if (grid.size() != 2) return scene_.robots.push_back(spawn);
    const double pitch = node.number("pitch", 0.4);
    for (double y = 0; y < grid[1]; ++y) {
      for (double x = 0; x < grid[0]; ++x) {
        RobotSpawn one = spawn;
        one.X_WR.p += Vec3{x - (grid[0] - 1) / 2, y - (grid[1] - 1) / 2, 0} * pitch;
        one.name = fmt::format("{} {}", node.text("name", scene_.robot_models[spawn.model].name),
                               scene_.robots.size() + 1);
        scene_.robots.push_back(std::move(one));
      }
    }
  }

  void read_params(const YamlNode& node, RobotSpawn& spawn) {
    if (node.kind != YamlKind::mapping) {
      out_.add(Code::R103, document_.head(node), "expected a mapping of parameters");
      return;
    }
    for (const YamlPair& pair : node.pairs) {
      const YamlNode& value = pair.value;
      if (value.kind != YamlKind::scalar) {
        out_.add(Code::R103, document_.head(value),
                 "a parameter is a number, a text, or true or false");
        continue;
        // Quotes make a text of anything, as in YAML.
      }
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

  void read_cache(const FormView& node) {
    CacheSpawn cache;
    cache.range = document_.head(node.node());
    const auto model = model_of(node);
    if (!model) return;
    cache.model = *model;
    const double side = scene_.models[*model].side;
    if (!scene_.caches.empty() && scene_.caches.front().model != cache.model) {
      out_.add(Code::S609, cache.range, "all caches of a scene have the same kind of block");
    }
    cache.at = node.vector("at", {0, 0, side / 2});
    cache.radius = node.number("radius", cache.radius);
    cache.yaw = node.number("yaw") * kDegree;
    cache.jitter = node.number("jitter");
    cache.turn_jitter = node.number("turn_jitter") * kDegree;
    cache.stock = static_cast<std::size_t>(node.number("stock", 100));
    scene_.caches.push_back(cache);
  }

  void read_noise(const FormView& node) {
    CameraNoise& camera = scene_.camera_noise;
    camera.pixel = node.number("pixels");
    camera.missed_tags = node.number("missed_tags");
    camera.missed_leds = node.number("missed_leds");
    camera.false_tags = node.number("false_tags");
    camera.false_leds = node.number("false_leds");
    camera.colour = node.number("colour");
    camera.latency = static_cast<int>(node.number("camera_latency"));
    scene_.range_noise.distance = node.number("distance");
    scene_.range_noise.latency = static_cast<int>(node.number("range_latency"));
  }

  // A file that failed is remembered as such, and reported once.
  std::optional<std::size_t> robot_model_of(const YamlNode& key) {
    for (const auto& [known, model] : robot_models_) {
      if (known == key.text) return model;
    }
    std::optional<std::size_t> model;
    if (auto source = load(key, key.text)) {
      if (auto robot = read_robot(std::move(source), out_)) {
        model = scene_.robot_models.size();
        scene_.robot_models.push_back(std::move(*robot));
      }
    }
    robot_models_.emplace_back(key.text, model);
    return model;
  }

  // Programs are known by the name that the scene has for them: one state of text each, however
  // many robots run it.
  std::size_t program_of(const YamlNode& node, const std::string& name) {
    for (std::size_t i = 0; i < scene_.programs.size(); ++i) {
      if (scene_.programs[i].path == name) return i;
    }
    const SourceRef source = load(node, name);
    if (!source) return RobotSpawn::kNoProgram;
    LuaProgram program{name, source->text(), {}, true};
    add_modules(program, program.text);
    scene_.programs.push_back(std::move(program));
    scene_.program_keys.push_back(document_.head(node));
    return scene_.programs.size() - 1;
  }

  /// What a program requires comes with the scene, so that traces can run it again. A file that
  /// is not there is the program's business: it may ask for it in vain.
  // Depth is bounded by the number of modules, each of which is taken once.
  void add_modules(LuaProgram& program, const std::string& text) {
    for (const std::string& name : required_names(text)) {
      const bool known = std::any_of(program.modules.begin(), program.modules.end(),
                                     [&](const auto& module) { return module.first == name; });
      if (known || program.modules.size() == kMostModules) continue;
      const std::string path =
          program.path.substr(0, program.path.rfind('/') + 1) + module_file(name);
      FileError error;
      // Not `load`: a file that is missing here is no error.
      const auto module = load_(path, kMostLuaSource, error);
      if (!module) continue;
      const bool kept = std::any_of(scene_.files.begin(), scene_.files.end(),
                                    [&](const SceneFile& file) { return file.name == path; });
      if (!kept) scene_.files.push_back({path, *module});
      program.modules.emplace_back(name, *module);
      add_modules(program, *module);
    }
  }

  /// The number of the entry's block among the models; each file is read once.
  std::optional<std::size_t> model_of(const FormView& node) {
    const YamlNode* key = node.find("file");
    const std::string name = key == nullptr ? std::string(kDefaultBlock) : key->text;
    for (const auto& [known, model] : models_) {
      if (known == name) return model;
    }
    std::optional<std::size_t> model;
    if (auto source = load(key == nullptr ? node.node() : *key, name)) {
      if (auto block = read_block(std::move(source), out_)) {
        // Without an offset a block has no magnets (BlockModel::has_magnets).
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
  const BadNodes& bad_;
  const SceneLoader& load_;
  Diagnostics& out_;
  Scene scene_;
  bool magnets_ = true;
  std::vector<std::pair<std::string, std::optional<std::size_t>>> models_, robot_models_;
};

}  // namespace

SceneLoader disk_loader(std::string scene_folder, std::vector<std::string> folders) {
  // Beside the scene first, so that a user's file goes before one that ships.
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
    // What it says when it is nowhere: the message names the first place.
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
  // At most 8 levels deep and 200,000 nodes.
  const auto document = parse_yaml(std::move(source), {kMaxSceneBytes, 8, 200'000}, own);
  if (document) {
    const BadNodes bad = check_form(*document, scene_keys(), own);
    if (!own.has_errors()) scene = Reader(*document, bad, load, own).read();
  }
  diagnostics.append(own);
  return own.has_errors() ? std::nullopt : std::move(scene);
}

}  // namespace stig
