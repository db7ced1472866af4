// SPDX-License-Identifier: MIT
// stigc validate: robots build the structure of a rule set in the physical world, and what they
// build is held to the rules.
//
// From rules to report in five steps, each of which can refuse with a reason: compile, set up (or
// read) the scene, run the trials, judge, write. A scene may be the user's own: then it says what
// robots there are, and the command line must not contradict it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "base/file_io.h"
#include "base/hash.h"
#include "base/left_behind.h"
#include "base/text.h"
#include "commands.h"
#include "compile_report.h"
#include "compiler/block_figures.h"
#include "compiler/compile.h"
#include "compiler/conflict_text.h"
#include "compiler/decision_text.h"
#include "given_scene.h"
#include "other_rules.h"
#include "outputs.h"
#include "page_template.h"
#include "physical/scene/scene_programs.h"
#include "report.h"
#include "report_player.h"
#include "robot_input.h"
#include "rules/rule_printer.h"
#include "rules/worked_from.h"
#include "runtime_input.h"
#include "scene_input.h"
#include "scene_text.h"
#include "validate/crew.h"
#include "validate/out_of_reach.h"
#include "validate/progress_svg.h"
#include "validate/set_up.h"
#include "validate_report.h"
#include "validate_runs.h"
#include "validation_folder.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

/// One validation, from the rules to the report.
class Validation {
 public:
  Validation(const ValidateOptions& options, App& app) : options_(options), app_(app) {}

  int run() {
    if (options_.detail && !options_.output) {
      app_.complain("--trace-detail says what traces have: add -o DIR");
      return kUsage;
    }
    if (const int code = compile(); code != kOk) return code;
    if (const int code = load(); code != kOk) return code;
    if (const int code =
            options_.output ? prepare_validation(*options_.output, output_names(), app_) : kOk;
        code != kOk)
      return code;
    // The report plays the runs; without the viewer it has pictures of them.
    const auto player = options_.output ? shipped_page_template() : std::nullopt;
    const bool pictures = options_.output && !player;
    if (options_.output && !journal_.open(*options_.output, work_hash(pictures), app_)) {
      return kRunFailed;
    }
    // Whoever has the journal is the only one to write here.
    if (options_.output) remove_left_behind(*options_.output, output_names());
    // Runs share the scene and differ by their seeds alone.
    TrialBatch batch = run_trials(target_, *scene_, options_, duration_, pictures, journal_, app_);
    if (batch.diagnostics.has_errors()) {
      app_.report(batch.diagnostics);
      return kFailed;
    }
    if (batch.trials.empty()) {
      app_.complain("interrupted before the first run");
      return kRunFailed;
    }
    for (Trial& trial : batch.trials) {
      trial.cannot = out_of_reach(target_, compiled_, *scene_, trial);
    }
    ValidationReport report{&target_, decision_text(*rules_, *compiled_.decision),
                            robots_text(compiled_), std::move(batch.trials), &compiled_};
    app_.print(options_.json ? dump(to_json(report)) : lines_of(report, app_.color_out()));
    if (pictures) report.no_player = kNoPlayer;
    if (player && batch.complaints.empty()) {
      report.player = report_player(*player, batch.written, app_);
    }
    const int written = options_.output ? write(report, batch) : kOk;
    const bool broken = std::any_of(report.trials.begin(), report.trials.end(),
                                    [](const Trial& trial) { return broke_off(trial.end); });
    // 3 where a run broke off or a file is missing, 1 where robots have built something else.
    if (stop_requested() || written != kOk || !batch.journalled ||
        report.trials.size() < static_cast<std::size_t>(options_.runs)) {
      if (journal_.is_open()) app_.say("runs that are over are kept; the same command goes on");
      return kRunFailed;
    }
    if (journal_.is_open()) journal_.remove();
    if (broken) return kRunFailed;
    return all_complete(report) ? kOk : kFailed;
  }

 private:
  int compile() {
    rules_ = app_.read_rules(options_.file);
    if (!rules_) return kFailed;
    rules_ = worked_from_own(std::move(*rules_), options_.sides);
    const auto builder = read_builder({options_.robot, std::nullopt}, app_);
    if (!builder) return kFailed;
    robot_name_ = builder->robot.name;
    robot_ = abilities_of(builder->robot, figures_of(builder->block));
    stop_on_signals();
    CompileOptions settings;
    settings.verify.stop = settings.limits.stop = &stop_requested();
    for (const std::string& side : options_.sides) settings.sides.push_back(*parse_side(side));
    settings.robots = options_.robots;
    // One that has finished its structure may come to another, where sides are others'.
    settings.own_sides = options_.allocation == Allocation::fixed && structures() == 1;
    // In a scene of the user's the number of robots is known once it is read.
    if (!options_.scene) {
      settings.robots = robots_at_one(robots_of(*rules_, options_.robots, structures()),
                                      static_cast<std::size_t>(structures()));
    }
    Diagnostics diagnostics;
    compiled_ = compile_rules(*rules_, *robot_, settings, diagnostics);
    note_other_rules(*rules_, compiled_, *robot_, options_.robot, diagnostics);
    app_.report(diagnostics);
    if (stop_requested()) {
      app_.complain("interrupted before the first run");
      return kRunFailed;
    }
    // Pictures of what cannot be built go before the verdict.
    show_drawings(compiled_, app_);
    if (!compiled_.decision) return compiled_.unknown ? kRunFailed : kFailed;
    if (app_.invalid(diagnostics)) return kFailed;
    target_.rules = &*rules_;
    target_.whole = *compiled_.proof.structure;
    return kOk;
  }

  int structures() const { return options_.structures.value_or(1); }

  /// That the program has to reckon with: one that has finished its structure may come to another.
  static int robots_at_one(int robots, std::size_t structures) {
    const auto each =
        static_cast<int>((static_cast<std::size_t>(robots) + structures - 1) / structures);
    return std::max(each, std::min(robots, 2));
  }

  std::optional<std::string> scene_text() const {
    if (options_.scene) return given_scene(*options_.scene, app_);
    SetUpRequest request;
    request.structures = structures();
    request.robots = robots_of(*rules_, options_.robots, structures());
    request.allocation = options_.allocation;
    request.side = robot_->block.side;
    if (options_.robot) request.robot_file = kGivenRobot;
    return set_up_scene(*rules_, compiled_, request);
  }

  // The same text that stigc compile writes.
  std::optional<std::string> controller_text() const {
    const auto library = read_runtime(app_);
    if (!library) return std::nullopt;
    const std::string name = file_name(options_.file);
    return controller_lua(*rules_, name, plan_controller(*rules_, *robot_, compiled_), compiled_,
                          *library)
        .text;
  }

  int load() {
    if (options_.scene &&
        (options_.robots || options_.structures || options_.allocation == Allocation::dynamic_)) {
      app_.complain(
          "a scene says what structures and robots there are, and what sides are theirs: leave "
          "--structures, --robots and --allocation out");
      return kUsage;
    }
    auto text = scene_text();
    const auto controller = controller_text();
    if (!text || !controller) return kFailed;
    // What is written runs as long as what was run.
    if (options_.duration) text = with_duration(std::move(*text), *options_.duration);
    // The controller is found by its name, whatever lies on the disk; everything else where scenes
    // have it.
    const SceneLoader others = options_.scene ? scene_loader(*options_.scene) : own_loader();
    if (options_.scene && !controller_name_is_free(*options_.scene, *controller, others, app_)) {
      return kFailed;
    }
    const SceneLoader loader = [&](const std::string& name, std::size_t most, FileError& error) {
      if (name == kControllerFile) return controller;
      if (name == kGivenRobot && options_.robot) return read_file(*options_.robot, most, error);
      return others(name, most, error);
    };
    Diagnostics diagnostics;
    const auto source =
        std::make_shared<const SourceFile>(options_.scene.value_or(kSceneFile), std::move(*text));
    scene_ = read_scene(source, loader, diagnostics);
    const int crew = scene_ ? check_robots(diagnostics) : 0;
    // Placed for the first seed, to find faults; each run places for its own.
    const auto placed = scene_ ? place_scene(*scene_, options_.seed, diagnostics) : std::nullopt;
    if (placed) {
      target_.sites = find_sites(*rules_, target_.whole, compiled_.target->floor_level(), *scene_,
                                 *placed, diagnostics);
    }
    if (crew > 1) check_crew(diagnostics);
    if (!target_.sites.empty()) check_programs(*scene_, *placed, diagnostics);
    app_.report(diagnostics);
    if (target_.sites.empty() || app_.invalid(diagnostics)) return kFailed;
    say_who_is_another();
    duration_ = options_.duration.value_or(scene_->duration);
    return kOk;
  }

  /// One that robots work from, or `several`.
  bool is_side(const LuaValue& value, bool several) const {
    const auto sides = sides_in(value);
    return sides && (several || sides->size() == 1) &&
           std::all_of(sides->begin(), sides->end(), [&](ApproachSide side) {
             return std::find(compiled_.sides.begin(), compiled_.sides.end(), side) !=
                    compiled_.sides.end();
           });
  }

  /// The scene's files that are written, those in folders below its own among them; others stay
  /// where they are.
  std::vector<const SceneFile*> written_scene_files() const {
    std::vector<const SceneFile*> files;
    for (const SceneFile& file : scene_->files) {
      const bool scene = &file == &scene_->files.front();
      const fs::path path(file.name);
      // A name with .. would be written outside of the folder that the user named.
      const bool outside =
          path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
      if (scene || !outside) files.push_back(&file);
    }
    return files;
  }
  std::string written_name(const SceneFile& file) const {
    return &file == &scene_->files.front() ? kSceneFile : file.name;
  }

  /// Every file that is written into the folder.
  std::vector<std::string> output_names() const {
    std::vector<std::string> names;
    for (const SceneFile* file : written_scene_files()) names.push_back(written_name(*file));
    return validation_files(std::move(names), options_.seed, options_.runs);
  }

  /// Is every robot of the scene bound to sides that no other works from?
  bool have_own_sides() const {
    std::set<ApproachSide> taken;
    for (const RobotSpawn& robot : scene_->robots) {
      if (!is_builder(*scene_, robot)) continue;
      const LuaValue* sides = param_of(robot, "sides");
      if (sides == nullptr || !is_side(*sides, true)) return false;
      const auto own = sides_in(*sides);
      for (const ApproachSide side : *own) {
        if (!taken.insert(side).second) return false;
      }
    }
    return true;
  }

  /// The compiled program asks on which side it begins. How many robots have it?
  int check_robots(Diagnostics& diagnostics) const {
    int count = 0;
    for (const RobotSpawn& robot : scene_->robots) {
      const LuaValue* side = param_of(robot, "side");
      const LuaValue* sides = param_of(robot, "sides");
      const bool begins = side != nullptr && is_side(*side, false);
      const bool bound = sides == nullptr || is_side(*sides, true);
      const bool compiled = is_builder(*scene_, robot);
      count += compiled ? 1 : 0;
      if (!compiled || (begins && bound)) continue;
      diagnostics
          .add(Code::V802, robot.range,
               fmt::format("'{}' is {}", robot.name,
                           begins            ? "bound to sides that nobody works from"
                           : side != nullptr ? "to begin on a side that nobody works from"
                                             : "not told on which side it begins"))
          .note(fmt::format("`params: {{side: \"{}\"}}`, or another that robots work from",
                            to_string(compiled_.sides.front())));
    }
    return count;
  }

  /// A robot of the scene that is none of those for which the program is compiled, the first one:
  /// it may be one that was changed a little, for which the program is good enough.
  void say_who_is_another() const {
    for (const RobotSpawn& robot : scene_->robots) {
      const std::string& model = scene_->robot_models[robot.model].name;
      if (!is_builder(*scene_, robot) || model == robot_name_) continue;
      app_.say(fmt::format("'{}' is a '{}', and its program is compiled for a '{}': see --robot",
                           printable(robot.name), printable(model), printable(robot_name_)));
      return;
    }
  }

  /// A scene of several robots, whatever the file says.
  void check_crew(Diagnostics& diagnostics) {
    if (!options_.scene) return;
    // Not what the rules' file says.
    compiled_.robots = robots_at_one(static_cast<int>(scene_->robots.size()),
                                     std::max<std::size_t>(1, target_.sites.size()));
    compiled_.own_sides = target_.sites.size() < 2 && have_own_sides();
    report_conflict(*rules_, compiled_, diagnostics);
  }

  /// Of all that runs depend on but their seeds. Files have the programs in them.
  std::uint64_t work_hash(bool pictures) const {
    std::uint64_t sum = combine(hash_text("validate"), rule_set_hash(*rules_));
    for (const SceneFile& file : scene_->files) {
      sum = combine(combine(sum, hash_text(file.name)), hash_text(file.text));
    }
    const std::string rest =
        fmt::format("{} {} {} {}", duration_, options_.detail, pictures, options_.seed);
    return combine(sum, hash_text(rest));
  }

  bool write_one(const std::string& name, const std::string& text) const {
    const fs::path path = fs::path(*options_.output) / name;
    std::error_code ignored;  // what it means, the next line says
    fs::create_directories(path.parent_path(), ignored);
    FileError error;
    if (write_file(path.string(), text, error)) return true;
    app_.complain(error.message);
    return false;
  }

  // What can be written is, even if one file cannot.
  int write(const ValidationReport& report, const TrialBatch& batch) const {
    for (const std::string& complaint : batch.complaints) app_.complain(complaint);
    bool good = batch.complaints.empty();
    for (const SceneFile* file : written_scene_files()) {
      good = write_one(written_name(*file), file->text) && good;
    }
    const std::vector<ProgressCurve> curves = curves_of(report);
    const ProgressBand band = band_of(curves);
    const auto bricks =
        static_cast<int>(target_.sites.size() * (target_.whole.size() - rules_->start.size()));
    const std::string texts[] = {progress_csv(curves, band), progress_svg(curves, band, bricks),
                                 dump(to_json(report)), report_html(report)};
    for (std::size_t i = 0; i < kReportFiles.size(); ++i) {
      good = write_one(kReportFiles[i], texts[i]) && good;
    }
    if (good) {
      app_.say(
          fmt::format("wrote {}/report.html and what belongs to it", printable(*options_.output)));
      say_what_is_older();
    }
    return good ? kOk : kRunFailed;
  }

  void say_what_is_older() const {
    const auto others = other_traces(*options_.output, output_names());
    if (others.empty()) return;
    app_.say(fmt::format("of an earlier validation, and not in the report: {}{}", others.front(),
                         others.size() == 1
                             ? ""
                             : fmt::format(" and {}", counted(others.size() - 1, "other trace"))));
  }

  const ValidateOptions& options_;
  App& app_;
  std::optional<RuleSet> rules_;
  std::optional<Abilities> robot_;
  std::string robot_name_;
  CompiledRules compiled_;
  std::optional<Scene> scene_;
  BuildTarget target_;
  TrialJournal journal_;
  double duration_ = kMostBuildTime;
};

}  // namespace

int run(const ValidateOptions& options, App& app) {
  if (!options.run) return Validation(options, app).run();
  if (options.runs > 1) {
    app.complain("--run is one of --runs by itself: leave one of them out");
    return kUsage;
  }
  // Runs are told apart by their seeds, one after the other.
  ValidateOptions alone = options;
  alone.seed += static_cast<std::uint64_t>(*options.run);
  return Validation(alone, app).run();
}

}  // namespace stig::cli
