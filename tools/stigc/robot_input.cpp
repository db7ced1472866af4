// SPDX-License-Identifier: MIT
// Robots are found beside the file that names them, blocks with the program: the compiler's figures
// are those of the block that ships.
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

}  // namespace

std::optional<RobotModel> read_own_robot(const char* name, const App& app) {
  const SourceRef source = find_source(name, own_loader(), app);
  if (!source) return std::nullopt;
  Diagnostics diagnostics;
  auto robot = read_robot(source, diagnostics);
  app.report(diagnostics);
  return robot;
}

std::optional<Abilities> read_abilities(const std::optional<std::string>& robot_file,
                                        const App& app, const char* usual) {
  const SourceRef robot_source = robot_file
                                     ? find_source(*robot_file, scene_loader(*robot_file), app)
                                     : find_source(usual, own_loader(), app);
  const SourceRef block_source = find_source(kBlock, own_loader(), app);
  if (!robot_source || !block_source) return std::nullopt;
  Diagnostics diagnostics;
  const auto robot = read_robot(robot_source, diagnostics);
  const auto block = read_block(block_source, diagnostics);
  app.report(diagnostics);
  // Both are reported before either ends it.
  if (!robot || !block || app.invalid(diagnostics)) return std::nullopt;
  const std::vector<std::string> missing = lacking(*robot);
  // All that is missing, not the first thing.
  for (const std::string& sentence : missing) {
    app.complain(fmt::format("'{}' cannot build: {}", printable(robot->name), sentence));
  }
  if (!missing.empty()) return std::nullopt;
  return abilities_of(*robot, figures_of(*block));
}

}  // namespace stig::cli
