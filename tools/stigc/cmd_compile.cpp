// SPDX-License-Identifier: MIT
// stigc compile: what a robot does where, or why it cannot build the structure.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "commands.h"
#include "compile_report.h"
#include "compiler/compile.h"
#include "controllers/robot_reader.h"
#include "outputs.h"
#include "physical/block.h"
#include "scene_input.h"

namespace stig {
namespace {

constexpr const char* kDefaultRobot = "bebot.yaml";
constexpr const char* kBlock = "stigmergic.yaml";

/// A file that the user named, or one of the program's own.
SourceRef find_source(const std::string& name, const App& app) {
  FileError error;
  auto text = scene_loader(name)(std::filesystem::path(name).filename().string(),
                                 kMaxRobotFileBytes, error);
  if (text) return std::make_shared<const SourceFile>(name, std::move(*text));
  app.complain(error.message);
  return nullptr;
}

std::optional<Abilities> robot_of(const CompileFileOptions& options, const App& app) {
  const SourceRef robot_source = find_source(options.robot.value_or(kDefaultRobot), app);
  const SourceRef block_source = find_source(kBlock, app);
  if (!robot_source || !block_source) return std::nullopt;
  Diagnostics diagnostics;
  const auto robot = read_robot(robot_source, diagnostics);
  const auto block = read_block(block_source, diagnostics);
  app.report(diagnostics);
  if (!robot || !block || app.invalid(diagnostics)) return std::nullopt;
  const std::vector<std::string> missing = lacking(*robot);
  for (const std::string& sentence : missing) {
    app.complain(fmt::format("'{}' cannot build: {}", printable(robot->name), sentence));
  }
  if (!missing.empty()) return std::nullopt;
  BlockFigures figures;
  figures.look.side = block->side;
  figures.mass = block->mass();
  figures.magnet_offset = block->magnet_offset;
  figures.magnet_moment = block->magnet_moment();
  return abilities_of(*robot, figures);
}

int write(const std::string& path, const std::string& text, const App& app) {
  FileError error;
  if (!write_file(path, text, error)) {
    app.complain(error.message);
    return kRunFailed;
  }
  app.say("wrote " + printable(path));
  return kOk;
}

}  // namespace

int run(const CompileFileOptions& options, App& app) {
  std::string problem = options.output ? folder_problem(*options.output) : "";
  if (problem.empty()) problem = same_file_problem({options.output}, {options.file, options.robot});
  if (!problem.empty()) {
    app.complain(printable(problem));
    return kUsage;
  }
  const std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  const std::optional<Abilities> robot = robot_of(options, app);
  if (!robot) return kFailed;
  CompileOptions settings;
  for (const std::string& side : options.sides) settings.sides.push_back(*parse_side(side));
  stop_on_signals();
  settings.verify.seconds = options.budget;
  settings.verify.stop = &stop_requested();
  settings.limits.states = options.states;
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(*rules, *robot, settings, diagnostics);
  app.report(diagnostics);
  if (!compiled.decision) {
    for (const RefusalDrawing& one : compiled.drawings) app.say(one.title + ":\n" + one.drawing);
    return compiled.proof.interrupted ? kRunFailed : kFailed;
  }
  const std::string text = compile_text(options.target, *rules, *robot, compiled);
  if (options.output) return write(*options.output, text, app);
  app.print(text);
  return kOk;
}

}  // namespace stig
