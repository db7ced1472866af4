// SPDX-License-Identifier: MIT
// stigc compile: what a robot does where, or why it cannot build the structure.
//
// One compilation, five forms of its result. Everything that can go wrong with names of files is
// found before the compilation, which may take minutes.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "commands.h"
#include "compile_report.h"
#include "compiler/block_figures.h"
#include "compiler/compile.h"
#include "compiler/work_proof.h"
#include "other_rules.h"
#include "outputs.h"
#include "recheck/check_work.h"
#include "refusal_page.h"
#include "robot_input.h"
#include "robots/robot_description.h"
#include "rules/worked_from.h"
#include "runtime_input.h"
#include "validate/argos_experiment.h"

namespace stig::cli {
namespace {

// "-" as everywhere in the program.
bool is_standard_output(const std::optional<std::string>& path) { return path && *path == "-"; }

int write(const std::string& path, const std::string& text, App& app) {
  if (path != "-") return write_output(path, text, app);
  app.print(text);
  return kOk;
}

constexpr std::string_view kArgosEnding = ".argos";

CompileTarget target_of(const CompileFileOptions& options) {
  // An ending that says what it is spares the option.
  if (options.target) return *options.target;
  if (options.output && options.output->ends_with(".lua")) return CompileTarget::lua;
  if (options.output && options.output->ends_with(kArgosEnding)) return CompileTarget::argos;
  return CompileTarget::table;
}

/// An experiment has a number of robots; a program by itself need not say it.
std::optional<int> robots_for(const CompileFileOptions& options, const RuleSet& rules,
                              const App& app) {
  if (target_of(options) != CompileTarget::argos) return options.robots;
  if (!options.robots && !(rules.physical && rules.physical->robots)) {
    // Assumed, and said so: the number decides where robots stand.
    app.say(
        "assumed: one robot, since the rules do not say how many work at once; --robots N or "
        "`physical: {robots: N}` says it");
  }
  return robots_of(rules, options.robots);
}

/// What is written for ARGoS, next to each other.
struct ArgosFiles {
  std::string experiment, robot, block;
};
std::optional<ArgosFiles> argos_files(const CompileFileOptions& options) {
  if (!options.output || target_of(options) != CompileTarget::argos) return std::nullopt;
  // The three names begin alike, whether the ending was given or not.
  std::string name = *options.output;
  if (name.ends_with(kArgosEnding)) name.resize(name.size() - kArgosEnding.size());
  return ArgosFiles{name + ".argos", name + "_robot.lua", name + "_block.lua"};
}

std::optional<std::string> line_map_of(const CompileFileOptions& options) {
  if (const auto argos = argos_files(options)) return argos->robot + ".map";
  if (!options.output || is_standard_output(options.output)) return std::nullopt;
  if (target_of(options) != CompileTarget::lua) return std::nullopt;
  // Beside the program, as its own name and .map.
  return *options.output + ".map";
}

/// The scripts first: an experiment never names what is not there.
int write_argos(const CompileFileOptions& options, const CompileJob& job, App& app) {
  const auto library = read_runtime(app);
  const auto adapter = read_module(kArgosAdapter, app), block = read_module(kArgosBlock, app);
  const auto robot = read_own_robot(kArgosRobot, app);
  // All are read before anything is written.
  if (!library || !adapter || !block || !robot) return kFailed;
  const ArgosFiles files = *argos_files(options);
  const ControllerText program =
      controller_argos(*job.rules, file_name(options.file), job.plan, *job.compiled,
                       robot_description(*robot), *adapter, *library);
  SetUpRequest request;
  request.robots = robots_of(*job.rules, options.robots);
  request.side = job.robot->block.side;
  // By plain names: ARGoS finds scripts beside the experiment.
  const std::string experiment = argos_experiment(*job.rules, *job.compiled, request,
                                                  {file_name(files.robot), file_name(files.block)});
  const std::pair<std::string, std::string> written[] = {
      {files.robot + ".map", line_map_json(job, program)},
      {files.robot, program.text},
      {files.block, *block},
      {files.experiment, experiment}};
  for (const auto& [path, text] : written) {
    if (const int code = write(path, text, app); code != kOk) return code;
  }
  return kOk;
}

int print(const CompileFileOptions& options, const CompileJob& job, App& app) {
  std::string text, map;
  // The report is the table, whatever the main result is.
  const auto report = [&] {
    return options.report ? write(*options.report, compile_table(job), app) : kOk;
  };
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
      ControllerText program =
          controller_lua(*job.rules, file_name(options.file), job.plan, *job.compiled, *library);
      map = line_map_json(job, program);
      text = std::move(program.text);
      break;
    }
    case CompileTarget::argos: {
      const int code = write_argos(options, job, app);
      return code == kFailed ? code : std::max(code, report());
    }
  }
  int worst = report();
  if (const auto path = line_map_of(options)) worst = std::max(worst, write(*path, map, app));
  if (options.output) return std::max(worst, write(*options.output, text, app));
  app.print(text);
  return worst;
}

std::string argos_problem(const CompileFileOptions& options) {
  if (target_of(options) != CompileTarget::argos) return {};
  if (options.robot) return "ARGoS brings its own robot, the BuilderBot: leave --robot out";
  if (options.block) return "ARGoS brings its own block: leave --block out";
  if (!options.output || is_standard_output(options.output))
    return "for ARGoS several files are written: say where with -o NAME";
  const std::string name = file_name(argos_files(options)->experiment);
  if (name == kArgosEnding) return fmt::format("'{}' has no name before .argos", *options.output);
  // The name goes into an XML attribute of the experiment.
  if (printable(name) != name)
    return fmt::format("the name '{}' cannot stand in an experiment's file", name);
  return {};
}

std::string usage_problem(const CompileFileOptions& options) {
  if (std::string problem = argos_problem(options); !problem.empty()) return problem;
  if (options.page && !options.page->ends_with(".html")) {
    return fmt::format("'{}': a page is .html", *options.page);
  }
  if (is_standard_output(options.certificate)) return "say in which file the certificate goes";
  if (is_standard_output(options.report) &&
      (!options.output || is_standard_output(options.output))) {
    return "standard output takes the program or the table: say where the other goes";
  }
  return {};
}

/// Every file that is written.
std::vector<std::string> output_names(const CompileFileOptions& options) {
  std::vector<std::string> names;
  if (const auto argos = argos_files(options)) {
    names = {argos->experiment, argos->robot, argos->block};
  } else if (options.output && !is_standard_output(options.output)) {
    names = {*options.output};
  }
  if (const auto map = line_map_of(options)) names.push_back(*map);
  if (options.report && !is_standard_output(options.report)) names.push_back(*options.report);
  if (options.page) names.push_back(*options.page);
  if (options.certificate) names.push_back(*options.certificate);
  return names;
}

// The checker certifies less than the compiler proves: who writes a certificate is to know at once.
void note_refusal(const std::string& text, const RuleSet& rules, const Builder& builder,
                  const App& app) {
  Diagnostics problems;
  const auto certificate = read_work_certificate("", text, problems);
  if (!certificate) return;
  const WorkReport report =
      check_work(rules, recheck::figures_of(builder.robot, builder.block), *certificate);
  if (!report.accepted)
    app.say(fmt::format("note: `stigc certify` refuses it: {}", report.refusal));
}

// Without a budget the work is bounded by steps, so that the result does not depend on the
// machine.
CompileOptions settings_of(const CompileFileOptions& options, const RuleSet& rules,
                           const App& app) {
  CompileOptions settings;
  for (const std::string& side : options.sides) settings.sides.push_back(*parse_side(side));
  settings.robots = robots_for(options, rules, app);
  settings.verify.seconds = options.budget.value_or(kNoTimeLimit);
  settings.verify.stop = &stop_requested();
  settings.limits.states = options.states;
  settings.limits.stop = &stop_requested();
  return settings;
}

}  // namespace

int run(const CompileFileOptions& options, App& app) {
  if (const std::string problem = usage_problem(options); !problem.empty()) {
    app.complain(printable(problem));
    return kUsage;
  }
  std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  // Rules whose own `sides` narrow them are compiled for these.
  rules = worked_from_own(std::move(*rules), options.sides);
  const std::optional<Builder> builder =
      read_builder({options.robot, options.block,
                    target_of(options) == CompileTarget::argos ? kArgosRobot : kPaperRobot},
                   app);
  if (!builder) return kFailed;
  const Abilities robot = abilities_of(builder->robot, compiler::figures_of(builder->block));
  if (const int code = check_outputs(output_names(options), app); code != kOk) return code;
  const CompileOptions settings = settings_of(options, *rules, app);
  stop_on_signals();
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(*rules, robot, settings, diagnostics);
  note_other_rules(*rules, compiled, robot, options.robot, diagnostics);
  app.report(diagnostics);
  // Asked before the result is taken for a refusal: an interrupted proof refuses too.
  if (stop_requested()) {
    app.complain("interrupted: nothing was written");
    return kRunFailed;
  }
  show_drawings(compiled, app);
  if (options.page && !diagnostics.all().empty()) {
    const int code = write_refusal_page(*options.page, *rules, compiled, diagnostics, app);
    if (code != kOk) return code;
  }
  if (!compiled.decision) return compiled.unknown ? kRunFailed : kFailed;
  // Warnings count as errors where the user wants that.
  if (app.invalid(diagnostics)) return kFailed;
  const CompileJob job{&*rules, &robot, &compiled, plan_controller(*rules, robot, compiled)};
  if (options.certificate) {
    const auto text = print_work_certificate(certificate_of_work(*rules, compiled, job.plan));
    if (const int code = write(*options.certificate, text, app); code != kOk) return code;
    note_refusal(text, *rules, *builder, app);
  }
  return print(options, job, app);
}

}  // namespace stig::cli
