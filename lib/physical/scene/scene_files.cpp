// SPDX-License-Identifier: MIT
// The files that a scene names: blocks, robots, programs with what they require; and the loaders
// that find them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/text.h"
#include "physical/scene/scene_parts.h"
#include "robots/robot_reader.h"

namespace stig::physics {

namespace {

// A pose file of the largest scene has about 2 MiB.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 22;  ///< of blocks and poses
constexpr std::size_t kMostModules = 64;                     ///< of one program
constexpr std::string_view kDefaultBlock = "stigmergic.yaml";

}  // namespace

// A file that failed is remembered as such, and reported once.
std::optional<std::size_t> NamedFiles::robot_model_of(const YamlNode& key) {
  for (const auto& [known, model] : robot_models_) {
    if (known == key.text) return model;
  }
  std::optional<std::size_t> model;
  if (auto source = load(key, key.text)) {
    if (auto robot = read_robot(std::move(source), out_, loader_from(key.text))) {
      model = scene_.robot_models.size();
      scene_.robot_models.push_back(std::move(*robot));
    }
  }
  robot_models_.emplace_back(key.text, model);
  return model;
}

// Programs are known by the name that the scene has for them: each is read once, however many
// robots run it.
std::size_t NamedFiles::program_of(const YamlNode& node, const std::string& name) {
  for (std::size_t i = 0; i < scene_.programs.size(); ++i) {
    if (scene_.programs[i].path == name) return i;
  }
  const SourceRef source = load(node, name);
  if (!source) return RobotSpawn::kNoProgram;
  LuaProgram program{name, source->text(), {}, true, scene_.interface};
  written_.emplace_back();
  if (scene_.interface == InterfaceLevel::of_2019) {
    written_.back().add_text(program.text);
    add_searched(program, written_.back());
  } else {
    add_modules(program, program.text);
  }
  scene_.programs.push_back(std::move(program));
  scene_.program_keys.push_back(document_.head(node));
  return scene_.programs.size() - 1;
}

void NamedFiles::add_params(std::size_t program, const RobotSpawn& spawn) {
  if (program == RobotSpawn::kNoProgram || scene_.interface != InterfaceLevel::of_2019) return;
  for (const auto& [name, value] : spawn.params) {
    if (const auto* text = std::get_if<std::string>(&value)) written_[program].add_name(*text);
  }
  add_searched(scene_.programs[program], written_[program]);
}

FileLoader NamedFiles::loader_from(const std::string& from) {
  return [this, folder = std::filesystem::path(from).parent_path()](
             const std::string& name, std::size_t most, FileError& error) {
    const std::string path = (folder / name).lexically_normal().string();
    auto text = load_(path, most, error);
    if (text) keep(path, *text);
    return text;
  };
}

void NamedFiles::keep(const std::string& name, const std::string& text) {
  const bool kept = std::any_of(scene_.files.begin(), scene_.files.end(),
                                [&](const SceneFile& file) { return file.name == name; });
  if (!kept) scene_.files.push_back({name, text});
}

/// The text of a module's file, which comes with the scene; nothing where there is no such file.
std::optional<std::string> NamedFiles::module_text(const std::string& path) {
  FileError error;
  // Not `load`: a file that is missing here is no error.
  auto text = load_(path, kMostLuaSource, error);
  if (!text) return std::nullopt;
  keep(path, *text);
  return text;
}

/// Every file that a name written somewhere may stand for, until no file brings new names. All that
/// exist are taken, not the first alone: which comes first may change while the program runs.
void NamedFiles::add_searched(LuaProgram& program, WrittenModules& written) {
  std::set<std::string> tried;
  for (bool more = true; more;) {
    more = false;
    const std::vector<std::string> names = written.names;
    const std::string templates = written.templates;
    for (const std::string& name : names) {
      for (const std::string& path : module_candidates(name, templates, program.path)) {
        const bool known = std::any_of(program.modules.begin(), program.modules.end(),
                                       [&](const auto& module) { return module.first == path; });
        if (known || program.modules.size() == kMostModules || !tried.insert(path).second) continue;
        const auto text = module_text(path);
        if (!text) continue;
        program.modules.emplace_back(path, *text);
        written.add_text(*text);
        more = true;
      }
    }
  }
}

/// What a program requires comes with the scene, so that traces can run it again. A file that
/// is not there is the program's business: it may ask for it in vain. Depth is bounded by the
/// number of modules, each of which is taken once.
void NamedFiles::add_modules(LuaProgram& program, const std::string& text) {
  for (const std::string& name : required_names(text)) {
    const bool known = std::any_of(program.modules.begin(), program.modules.end(),
                                   [&](const auto& module) { return module.first == name; });
    if (known || program.modules.size() == kMostModules) continue;
    const auto module = module_text(module_path(program, name));
    if (!module) continue;
    program.modules.emplace_back(name, *module);
    add_modules(program, *module);
  }
}

std::optional<std::size_t> NamedFiles::model_of(const FormView& node) {
  const YamlNode* key = node.find("file");
  const std::string name = key == nullptr ? std::string(kDefaultBlock) : key->text;
  for (const auto& [known, model] : models_) {
    if (known == name) return model;
  }
  std::optional<std::size_t> model;
  if (auto source = load(key == nullptr ? node.node() : *key, name)) {
    if (auto block = read_block(std::move(source), out_)) {
      // Without an offset a block has no magnets (BlockModel::has_magnets).
      if (!scene_.magnets) block->magnet_offset = 0;
      model = scene_.models.size();
      scene_.models.push_back(std::move(*block));
    }
  }
  models_.emplace_back(name, model);
  return model;
}

SourceRef NamedFiles::load(const YamlNode& node, const std::string& name) {
  FileError error;
  auto text = load_(name, kMaxFileBytes, error);
  if (!text) {
    out_.add(error.too_large ? Code::R002 : Code::R001, document_.head(node), error.message);
    return nullptr;
  }
  scene_.files.push_back({name, *text});
  return std::make_shared<const SourceFile>(name, std::move(*text));
}

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

}  // namespace stig::physics
