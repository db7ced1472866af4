// SPDX-License-Identifier: MIT
// stigc build: from a drawing to robots that have built it, the three commands in a row.
//
// Each step is the command that a user would give, with its own checks and messages, so that build
// cannot differ from what the three commands do, and its files can be used with any of them. Names
// in the folder are fixed: a folder can be built into again.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "commands.h"
#include "lattice/structure_files.h"
#include "mesh_input.h"
#include "outputs.h"
#include "robot_input.h"
#include "synth_words.h"
#include "validate/set_up.h"
#include "validation_folder.h"

namespace stig::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRules = "rules.yaml";
constexpr const char* kDecisions = "decisions.txt";
constexpr const char* kTarget = "target.png";
constexpr const char* kBuilt = "built.png";

class BuildWork {
 public:
  BuildWork(const BuildOptions& options, App& app) : options_(options), app_(app) {}

  int run() {
    if (const int code = prepare(); code != kOk) return code;
    app_.say("1 of 3: rules that the robot can follow");
    if (const int code = synth(); code != kOk) return leave(code);
    if (const int code = draw_target(); code != kOk) return code;
    app_.say("2 of 3: what a robot decides where");
    if (const int code = compile(); code != kOk) return code;
    app_.say("3 of 3: robots at work");
    const int code = validate();
    // A failed validation still leaves something to look at; a run that broke off does not.
    return code == kUsage || code == kRunFailed ? code : std::max(code, draw_built());
  }

 private:
  std::string in_folder(const std::string& name) const { return options_.output + "/" + name; }

  int prepare() {
    const std::string problem = bricks_problem(options_.mesh, {options_.target});
    if (!problem.empty()) {
      app_.complain(problem);
      return kUsage;
    }
    if (const int code = read_target(); code != kOk) return code;
    std::error_code ignored;
    made_folder_ = !fs::exists(options_.output, ignored);
    // The rules are the first file that a build writes, and say near their begin by whom.
    earlier_ = has_words(in_folder(kRules), {kMadeBySynth});
    const int code = prepare_folder(
        {options_.output, {kRules, kDecisions, kTarget, kBuilt}, earlier_, "build"}, app_);
    if (code != kOk) return code;
    // The last step would refuse as well, after all the work before it.
    std::vector<std::string> scene = {kSceneFile, std::string(kControllerFile)};
    if (options_.robot) scene.emplace_back(kGivenRobot);
    return prepare_validation(
        options_.output, validation_files(std::move(scene), options_.seed, options_.runs), app_);
  }

  /// Nothing was built: what is in the folder then is of an earlier build, if anything.
  int leave(int code) const {
    std::error_code ignored;
    if (earlier_) {
      app_.say(fmt::format("what is in '{}' is of an earlier build", printable(options_.output)));
    } else if (made_folder_) {
      fs::remove(options_.output, ignored);
    }
    return code;
  }

  int read_target() {
    if (is_mesh(options_.target)) {
      auto voxels = voxelise(options_.target, options_.mesh, app_);
      if (!voxels) return kFailed;
      target_ = std::move(voxels->loaded);
      return kOk;
    }
    Diagnostics diagnostics;
    target_ = read_structure_file(options_.target, {}, diagnostics);
    if (target_ && !app_.invalid(diagnostics)) return kOk;  // otherwise synth reports them
    app_.report(diagnostics);
    return kFailed;
  }

  int draw_target() const {
    std::string problem;
    const std::string title = fs::path(options_.target).filename().string();
    if (write_structure(in_folder(kTarget), target_->structure, target_->bricks, title, true,
                        problem)) {
      return kOk;
    }
    app_.complain(problem);
    return kRunFailed;
  }

  int synth() {
    SynthOptions wanted;
    wanted.target = options_.target;
    wanted.mesh = options_.mesh;
    // Rules depend on the robot: without one named it is the paper's, as in the steps that follow,
    // and no file of that name in the working folder.
    wanted.robot = options_.robot.value_or(kPaperRobot);
    wanted.shipped_robot = !options_.robot;
    wanted.sides = options_.sides;
    wanted.robots = options_.robots.value_or(1);
    wanted.kinds = options_.kinds;
    wanted.use = options_.use;
    wanted.colours = options_.colours;
    wanted.start = options_.start;
    wanted.effort = options_.effort;
    wanted.seconds = options_.seconds;
    wanted.output = in_folder(kRules);
    // By name: `run` of this class would be found first.
    return cli::run(wanted, app_);
  }

  int compile() {
    CompileFileOptions wanted;
    wanted.file = in_folder(kRules);
    wanted.robot = options_.robot;
    wanted.output = in_folder(kDecisions);
    return cli::run(wanted, app_);
  }

  int validate() {
    ValidateOptions wanted;
    wanted.file = in_folder(kRules);
    wanted.robot = options_.robot;
    wanted.duration = options_.duration;
    wanted.seed = options_.seed;
    wanted.runs = options_.runs;
    wanted.threads = options_.threads;
    wanted.output = options_.output;
    // The controller that is validated is compiled again from the rules, which takes no time next
    // to the rest.
    return cli::run(wanted, app_);
  }

  /// The end of the first run. What replay prints of it is no result here.
  int draw_built() const {
    ReplayOptions wanted;
    wanted.trace = in_folder(trace_name(options_.seed));
    wanted.outputs = {in_folder(kBuilt)};
    // A second App, whose output is never flushed.
    App drawing(app_.options());
    return cli::run(wanted, drawing);
  }

  const BuildOptions& options_;
  App& app_;
  std::optional<LoadedStructure> target_;
  bool earlier_ = false;      ///< the folder has the rules of another build
  bool made_folder_ = false;  ///< by this one
};

}  // namespace

int run(const BuildOptions& options, App& app) { return BuildWork(options, app).run(); }

}  // namespace stig::cli
