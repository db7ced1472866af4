// SPDX-License-Identifier: MIT
// Robots and blocks are found beside the file that names them, those that ship with the program.
#include "robot_input.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/text.h"
#include "compiler/block_figures.h"
#include "robots/robot_reader.h"
#include "scene_input.h"

namespace stig::cli {
namespace {

constexpr const char* kBlock = "stigmergic.yaml";

SourceRef find_source(const std::string& name, const SceneLoader& load, const App& app) {
  FileError error;
  // By the name alone, since a loader looks in folders of its own.
  auto text = load(std::filesystem::path(name).filename().string(), kMaxRobotFileBytes, error);
  if (text) return std::make_shared<const SourceFile>(name, std::move(*text));
  app.complain(error.message);
  return nullptr;
}

/// A program that a file names belongs to the input, though nothing here needs what it says: it is
/// read so that nothing is written over it. One that is not there is missed where it shall run.
void keep_program(const std::string& name, const SceneLoader& load) {
  FileError ignored;
  if (!name.empty()) load(name, kMaxSceneBytes, ignored);
}

}  // namespace

std::optional<RobotModel> read_own_robot(const char* name, const App& app) {
  const SourceRef source = find_source(name, own_loader(), app);
  if (!source) return std::nullopt;
  Diagnostics diagnostics;
  auto robot = read_robot(source, diagnostics, own_loader());
  app.report(diagnostics);
  return robot;
}

std::optional<Builder> read_builder(const BuilderFiles& files, const App& app) {
  const auto source = [&](const std::optional<std::string>& given, const char* usual) {
    return given ? find_source(*given, scene_loader(*given), app)
                 : find_source(usual, own_loader(), app);
  };
  const SourceRef robot_source = source(files.robot, files.usual);
  const SourceRef block_source = source(files.block, kBlock);
  if (!robot_source || !block_source) return std::nullopt;
  const SceneLoader beside_robot = files.robot ? scene_loader(*files.robot) : own_loader();
  const SceneLoader beside_block = files.block ? scene_loader(*files.block) : own_loader();
  Diagnostics diagnostics;
  auto robot = read_robot(robot_source, diagnostics, beside_robot);
  auto block = read_block(block_source, diagnostics);
  app.report(diagnostics);
  if (robot) keep_program(robot->program, beside_robot);
  if (block) keep_program(block->program, beside_block);
  // Both are reported before either ends it.
  if (!robot || !block || app.invalid(diagnostics)) return std::nullopt;
  const std::vector<std::string> missing = lacking(*robot);
  // All that is missing, not the first thing.
  for (const std::string& sentence : missing) {
    app.complain(fmt::format("'{}' cannot build: {}", printable(robot->name), sentence));
  }
  if (!missing.empty()) return std::nullopt;
  return Builder{std::move(*robot), std::move(*block)};
}

std::optional<Abilities> read_abilities(const BuilderFiles& files, const App& app) {
  const std::optional<Builder> builder = read_builder(files, app);
  if (!builder) return std::nullopt;
  return abilities_of(builder->robot, figures_of(builder->block));
}

}  // namespace stig::cli
