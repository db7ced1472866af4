// SPDX-License-Identifier: MIT
// stigc compile: what a robot does where, or why it cannot build the structure.
#include <fmt/format.h>

#include "base/file_io.h"
#include "commands.h"
#include "compile_report.h"
#include "compiler/compile.h"
#include "outputs.h"
#include "robot_input.h"

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
  const std::optional<Abilities> robot = read_abilities(options.robot, app);
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
