// SPDX-License-Identifier: MIT
// For rules that a robot is to follow, the search is another (assembly/assemble.h): what the
// command line says about symmetry, orders or merging has no meaning there, and is refused rather
// than ignored.
#include "synth_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/text.h"
#include "certify/certificate.h"
#include "compiler/precedence.h"
#include "outputs.h"
#include "progress.h"
#include "robot_input.h"
#include "structure_input.h"
#include "synth_words.h"

namespace stig::cli {
namespace {

/// More are not even asked whether robots could build them.
constexpr std::size_t kMostBricks = 200'000;

/// Kinds of brick that there may be.
int kinds_of(const SynthOptions& options) { return options.kinds.value_or(kBlockColours); }

/// What rules for robots cannot be asked to be; empty: nothing was asked.
std::string usage_problem(const SynthOptions& o) {
  // Only options that were given are named, one at a time: the first that does not go.
  const std::pair<bool, const char*> others[] = {{o.symmetry != Symmetry::none, "--symmetry"},
                                                 {o.fewest != Fewest::colours, "--fewest"},
                                                 {o.family.has_value(), "--order"},
                                                 {o.strict, "--strict"},
                                                 {o.exact, "--exact"},
                                                 {o.scaffold > 0, "--scaffold"},
                                                 {o.proof.has_value(), "--proof"}};
  for (const auto& [given, name] : others) {
    if (given) return fmt::format("{} does not go with --robot, which chooses by itself", name);
  }
  if (o.start.size() > 1) return "with --robot one brick is the start";
  if (o.colours && *o.colours > kinds_of(o)) {
    return fmt::format("of {} kinds of brick no more colours are to be had: --kinds N has more",
                       kinds_of(o));
  }
  return {};
}

/// What is wrong with the target itself; empty: nothing.
std::string target_problem(const SynthOptions& options, const Target& target) {
  if (target.cells.empty()) return "the target has no cells";
  if (target.cells.size() == 1) return "the target is a single brick, the start: there is no work";
  if (target.cells.size() > kMostBricks) {
    return fmt::format("the target has {} bricks, and --robot takes {} at most",
                       target.cells.size(), kMostBricks);
  }
  if (target.lattice != Lattice::cubic) {
    return "blocks are cubes: robots build on the cubic lattice alone";
  }
  if (static_cast<int>(target.bricks.size()) > kinds_of(options)) {
    return fmt::format("the target has {} kinds of brick, and blocks show {}: --kinds N has more",
                       target.bricks.size(), kinds_of(options));
  }
  const auto lowest = std::min_element(target.cells.begin(), target.cells.end(),
                                       [](Cell a, Cell b) { return a.z < b.z; });
  // A target that hovers or begins higher would need a floor that moves; cells are not shifted
  // silently, since --start names them.
  if (lowest->z != 0) {
    return fmt::format("the target's lowest level is z = {}, and robots build on the floor, z = 0",
                       lowest->z);
  }
  if (options.start.empty()) return {};
  const Cell start = options.start.front();
  if (std::find(target.cells.begin(), target.cells.end(), start) == target.cells.end()) {
    return fmt::format("the start {},{},{} is no brick of the target", start.x, start.y, start.z);
  }
  return start.z == 0 ? "" : "the start has to stand on the floor, z = 0";
}

// They go into the file, so that it says how it was made.
std::string robot_options_in_words(const SynthOptions& o) {
  std::string out = fmt::format(" --robot {}", file_name(*o.robot));
  if (o.robots) out += fmt::format(" --robots {}", *o.robots);
  if (!o.sides.empty()) out += fmt::format(" --sides={}", fmt::join(o.sides, ","));
  if (o.use == ColourUse::given) out += " --colours given";
  if (o.colours) out += fmt::format(" --colours {}", *o.colours);
  if (o.kinds) out += fmt::format(" --kinds {}", *o.kinds);
  for (const Cell c : o.start) out += fmt::format(" --start {},{},{}", c.x, c.y, c.z);
  if (o.effort != 1) out += fmt::format(" --effort {}", o.effort);
  return out;
}

AssemblyTask task_of(const SynthOptions& options, Target target, Abilities robot) {
  AssemblyTask out;
  const std::string file = file_name(options.target);
  out.wording = {set_name(options.target),
                 fmt::format("{}, {}", file, counted(target.cells.size(), "brick")),
                 fmt::format("{} from {}{}", kMadeBySynth, file, robot_options_in_words(options))};
  out.target = std::move(target);
  out.robot = std::move(robot);
  for (const std::string& side : options.sides) out.sides.push_back(*parse_side(side));
  out.robots = options.robots;
  if (!options.start.empty()) out.start = options.start.front();
  out.kinds = kinds_of(options);
  out.most_colours = options.colours.value_or(out.kinds);
  return out;
}

/// Those that came with the program, but the one that was named.
std::vector<OtherRobot> other_robots(const std::string& named, const App& app) {
  std::vector<OtherRobot> out;
  for (const char* name : {kPaperRobot, kArgosRobot}) {
    if (file_name(named) == name) continue;
    if (auto robot = read_abilities({std::nullopt, std::nullopt, name}, app)) {
      out.push_back({fmt::format("--robot robots/{}", name), std::move(*robot)});
    }
  }
  return out;
}

std::vector<std::string> robot_output_names(const SynthOptions& options) {
  std::vector<std::string> names;
  if (has_file(options)) names.push_back(*options.output);
  if (options.certificate) names.push_back(*options.certificate);
  return names;
}

int write_plan(const SynthOptions& options, const AssemblyPlan& plan, App& app,
               std::vector<std::string>& written) {
  int code = kOk;
  if (has_file(options)) {
    code = write_one(*options.output, plan.text, app, written);
  } else if (!options.json) {
    app.print(plan.text);
  }
  if (code != kOk || !options.certificate) return code;
  // The certificate is the proof of the compiled rules; without one there is none to write.
  if (const auto& certificate = plan.compiled.proof.certificate) {
    return write_one(*options.certificate, print_certificate(*certificate), app, written);
  }
  app.complain("there is no certificate: " + plan.compiled.proof.open);
  return kRunFailed;
}

/// A search that ended is no proof that there is nothing.
std::string why_not_found(const Target& target, const Assembly& made) {
  if (made.too_many) {
    // What comes before what is kept as a bit for each pair of bricks (compiler/precedence.h).
    return fmt::format(
        "unknown: nothing was found that rules {} out, and rules for more than {} are not looked "
        "for",
        counted(target.cells.size(), "brick"), kMostOrderedBricks);
  }
  if (made.cut_short) return fmt::format("not found: {}", ended_early());
  return fmt::format("not found: {}; --effort allows more", counts_in_words(made.counts));
}

/// An exit code.
int report(const SynthOptions& options, const Target& target, const Assembly& made,
           const std::vector<AssemblyRemedy>& remedies, App& app,
           std::vector<std::string>& written) {
  if (made.plan) {
    const int code = write_plan(options, *made.plan, app, written);
    if (options.json) return code;
    std::string lines = plan_lines(target, made);
    if (made.cut_short) lines += fmt::format("  note        {}\n", ended_early());
    if (has_file(options)) {
      app.print(lines);
    } else {
      app.say(lines);
    }
    return code;
  }
  if (made.obstacle) {
    if (!options.json) {
      app.print(obstacle_lines(target, *made.obstacle, app.color_out()) + remedy_lines(remedies));
    }
    return kFailed;
  }
  if (!options.json) {
    app.complain(why_not_found(target, made));
    app.print(remedy_lines(remedies));
  }
  return kRunFailed;
}

}  // namespace

int synth_for_robot(const SynthOptions& options, App& app) {
  assert(options.robot);
  if (const std::string problem = usage_problem(options); !problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  const auto loaded = read_structure(options.target, options.lattice, app, options.mesh);
  if (!loaded) return kFailed;
  const Target target = target_of(*loaded, options.use);
  if (const std::string problem = target_problem(options, target); !problem.empty()) {
    app.complain(problem);
    return kFailed;
  }
  const auto robot =
      options.shipped_robot
          ? read_abilities({std::nullopt, options.block, options.robot->c_str()}, app)
          : read_abilities({options.robot, options.block}, app);
  if (!robot) return kFailed;
  if (const int code = check_outputs(robot_output_names(options), app); code != kOk) return code;
  stop_on_signals();
  Progress progress(app);
  AssemblyHooks hooks;
  hooks.deadline = Deadline::after(options.seconds, &stop_requested());
  hooks.progress = [&](double fraction, const std::string& what) { progress.show(fraction, what); };
  const AssemblyTask task = task_of(options, target, *robot);
  const Assembly made = assemble(task, options.effort, hooks);
  std::vector<AssemblyRemedy> remedies;
  bool cut_short = made.cut_short;
  // Other robots are tried only when the one that was named cannot: as a remedy.
  if (!made.plan && !made.too_many) {
    progress.show(0, "what would help");
    remedies = find_remedies(task, made, other_robots(*options.robot, app), options.effort, hooks);
    cut_short = cut_short || hooks.deadline.passed();
  }
  progress.clear();
  std::vector<std::string> written;
  const int code = report(options, target, made, remedies, app, written);
  if (options.json) {
    app.print(
        assembly_json(options, target, made, remedies, cut_short, progress.seconds(), written));
  } else if (cut_short && !made.cut_short) {
    app.say(fmt::format("what would help: {}", ended_early()));
  }
  return code;
}

}  // namespace stig::cli
