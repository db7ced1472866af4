// SPDX-License-Identifier: MIT
// Programs are loaded and their init run before a long simulation begins: a slip in a program, or a
// step that is called steps, is told at its line like an error in the scene. They run in boxes that
// are thrown away, so that the run itself begins afresh.
#include "physical/scene/scene_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>
#include <tuple>

#include "physical/scene/lua_programs.h"

namespace stig::physics {

namespace {

constexpr std::size_t kMostTries = 200;  ///< of robots' programs, each of a call's instructions

/// The program's own file, or that of a module, by what messages call it; null: another.
SourceRef file_of(const LuaProgram& program, const std::string& name) {
  // Messages shorten long paths to their last part.
  const auto is = [&](const std::string& path) {
    return path == name || path.ends_with("/" + name);
  };
  if (name.empty() || is(program.path)) {
    return std::make_shared<const SourceFile>(program.path, program.text);
  }
  for (const auto& [module, text] : program.modules) {
    const std::string path = module_path(program, module);
    if (is(path)) return std::make_shared<const SourceFile>(path, text);
  }
  return nullptr;
}

/// The line without the spaces around it; of no line, the file's beginning.
SourceRange line_of(SourceRef file, std::size_t line) {
  const std::string_view text = file->line(line);
  const auto first = std::min(text.find_first_not_of(" \t"), text.size());
  const auto last = text.find_last_not_of(" \t\r");
  const auto start = line == 0 ? 0 : static_cast<std::uint32_t>(file->line_start(line));
  const auto end = last == text.npos ? first : last + 1;
  return {std::move(file), start + static_cast<std::uint32_t>(first),
          start + static_cast<std::uint32_t>(end)};
}

class ProgramCheck {
 public:
  ProgramCheck(const Scene& scene, const PlacedScene& placed, Diagnostics& out)
      : scene_(scene), placed_(placed), out_(out) {}

  void run() {
    for (std::size_t i = 0; i < scene_.robots.size(); ++i) try_robot(i);
    // Those too that are dropped while it runs.
    for (std::size_t i = 0; i < placed_.bodies.size(); ++i) {
      if (placed_.bodies[i].block) try_block(i);
    }
    if (auto script = script_of(scene_, placed_)) try_script(*script);
  }

 private:
  // Robots of one program, model and parameters fail alike: one is tried for all of them.
  void try_robot(std::size_t robot) {
    const RobotSpawn& spawn = scene_.robots[robot];
    if (spawn.program == RobotSpawn::kNoProgram || tried_.size() == kMostTries) return;
    if (!tried_.emplace(spawn.program, spawn.model, spawn.params).second) return;
    RobotCommands commands;
    // As the run prepares them, since a program may set one by its number.
    commands.camera_enabled.resize(scene_.robot_models[spawn.model].cameras.size());
    commands.sends.resize(scene_.robot_models[spawn.model].radios.size());
    commands.joints.resize(scene_.robot_models[spawn.model].actuators.size());
    try_one(*robot_program(scene_, placed_, robot), spawn.program, commands);
  }

  void try_block(std::size_t body) {
    const std::size_t program = scene_.block_programs[block_model(scene_, placed_, body)];
    if (program == RobotSpawn::kNoProgram || !blocks_.insert(program).second) return;
    BlockCommands commands;
    commands.sends.resize(kBlockRadios);
    try_one(*block_program(scene_, placed_, body), program, commands);
  }

  void try_one(auto& controller, std::size_t program, auto& commands) {
    if (!controller.init(commands).ok) {
      report(program, Code::S610, controller.failure());
    } else if (!controller.ready().ok) {
      report(program, Code::S611, controller.failure());
    }
  }

  void try_script(LuaScript& script) {
    const LuaScript::Loaded loaded = script.load();
    if (loaded == LuaScript::Loaded::good) return;
    report(scene_.script, loaded == LuaScript::Loaded::failed ? Code::S610 : Code::S611,
           script.failure());
  }

  /// Once for a program, whoever has it and however often it fails. Where its text is not at hand,
  /// the scene's own line has to do.
  void report(std::size_t program, Code code, const LuaFailure& failure) {
    if (!reported_.insert(program).second) return;
    const LuaProgram& text = scene_.programs[program];
    const SourceRef file = file_of(text, failure.file);
    out_.add(code, file ? line_of(file, failure.line) : scene_.program_keys[program], failure.what)
        .note(scene_.program_keys[program], "the scene names the program here");
  }

  const Scene& scene_;
  const PlacedScene& placed_;
  Diagnostics& out_;
  std::set<std::tuple<std::size_t, std::size_t, std::vector<std::pair<std::string, LuaValue>>>>
      tried_;
  std::set<std::size_t> blocks_, reported_;
};

}  // namespace

void check_programs(const Scene& scene, const PlacedScene& placed, Diagnostics& diagnostics) {
  assert(placed.robots.size() == scene.robots.size());
  ProgramCheck(scene, placed, diagnostics).run();
}

}  // namespace stig::physics
