// SPDX-License-Identifier: MIT
// stigc compile: what a robot does where, or why it cannot build the structure.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/file_io.h"
#include "commands.h"
#include "compile_report.h"
#include "compiler/compile.h"
#include "controllers/robot_reader.h"
#include "outputs.h"
#include "physical/block.h"
#include "runtime_input.h"
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

CompileTarget target_of(const CompileFileOptions& options) {
  const bool lua = options.output && options.output->ends_with(".lua");
  return options.target.value_or(lua ? CompileTarget::lua : CompileTarget::table);
}

std::optional<std::string> line_map_of(const CompileFileOptions& options) {
  if (!options.output || target_of(options) != CompileTarget::lua) return std::nullopt;
  return *options.output + ".map";
}

int print(const CompileFileOptions& options, const CompileJob& job, App& app) {
  std::string text, map;
  switch (target_of(options)) {
    case CompileTarget::table:
      text = compile_table(job);
      break;
    case CompileTarget::dot:
      text = compile_dot(job);
      break;
    case CompileTarget::ir:
      text = compile_ir(job);
      break;
    case CompileTarget::lua: {
      const auto library = read_runtime(app);
      if (!library) return kFailed;
      const std::string name = std::filesystem::path(options.file).filename().string();
      ControllerText program = controller_lua(*job.rules, name, job.plan, *job.compiled, *library);
      map = line_map_json(job, program);
      text = std::move(program.text);
      break;
    }
  }
  int worst = options.report ? write(*options.report, compile_table(job), app) : kOk;
  if (const auto path = line_map_of(options)) worst = std::max(worst, write(*path, map, app));
  if (options.output) return std::max(worst, write(*options.output, text, app));
  app.print(text);
  return worst;
}

std::string output_problem(const CompileFileOptions& options) {
  for (const auto& path : {options.output, options.report}) {
    std::string problem = path ? folder_problem(*path) : "";
    if (!problem.empty()) return problem;
  }
  return same_file_problem({options.output, options.report, line_map_of(options)},
                           {options.file, options.robot});
}

}  // namespace

int run(const CompileFileOptions& options, App& app) {
  if (const std::string problem = output_problem(options); !problem.empty()) {
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
  return print(options, {&*rules, &*robot, &compiled, plan_controller(*rules, *robot, compiled)},
               app);
}

}  // namespace stig
