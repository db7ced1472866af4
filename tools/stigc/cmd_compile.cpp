// SPDX-License-Identifier: MIT
// stigc compile: what a robot does where, or why it cannot build the structure.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/file_io.h"
#include "commands.h"
#include "compile_report.h"
#include "compiler/compile.h"
#include "outputs.h"
#include "robot_input.h"
#include "runtime_input.h"

namespace stig {
namespace {

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
  const std::optional<Abilities> robot = read_abilities(options.robot, app);
  if (!robot) return kFailed;
  CompileOptions settings;
  for (const std::string& side : options.sides) settings.sides.push_back(*parse_side(side));
  settings.robots = options.robots;
  stop_on_signals();
  settings.verify.seconds = options.budget;
  settings.verify.stop = &stop_requested();
  settings.limits.states = options.states;
  settings.limits.stop = &stop_requested();
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(*rules, *robot, settings, diagnostics);
  app.report(diagnostics);
  if (stop_requested()) {
    app.complain("interrupted: nothing was written");
    return kRunFailed;
  }
  for (const RefusalDrawing& one : compiled.drawings) app.say(one.title + ":\n" + one.drawing);
  if (!compiled.decision) return compiled.proof.interrupted ? kRunFailed : kFailed;
  return print(options, {&*rules, &*robot, &compiled, plan_controller(*rules, *robot, compiled)},
               app);
}

}  // namespace stig
