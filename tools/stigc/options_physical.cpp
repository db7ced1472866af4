// SPDX-License-Identifier: MIT
// The options of the commands about robots and the physical world. Files of scenes, robots and
// blocks have settings of their own; an option stands here when a run differs from the file.
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {
namespace {

constexpr const char* kSidesOfRobots =
    "the sides that robots work from, in place of the file's, as --sides=+x,-x; of symmetric rules "
    "those turns hold that these sides have";

}  // namespace

void add_replay(CLI::App& app, ReplayOptions& o) {
  CLI::App* sub = command(
      app, "replay", "look at a recorded run, or run it again and compare",
      "  stigc explore rulesets/staircase.yaml --trace run.stigt && stigc replay run.stigt\n"
      "  stigc simulate scenes/drop.yaml --trace drop.stigp && stigc replay drop.stigp\n"
      "  stigc replay drop.stigp --at 1.5 -o drop.png -o drop.csv\n"
      "  stigc replay drop.stigp -o drop.mcap\n"
      "  stigc replay drop.stigp --verify\n");
  file(sub, "TRACE", o.trace, "trace of explore, which is run again, or of simulate");
  sub->add_flag("--verify", o.verify,
                "run the scene again and compare the hashes of its states; traces of explore "
                "always are");
  moment(sub, "--at", o.at, "the moment to show, in simulated seconds (default: the end)");
  repeated(
      sub, "-o,--output", o.outputs, "FILE",
      "of a trace of simulate: .png draws that moment, as stigc render does; .csv has all poses "
      "as a table, .mcap all poses, shapes and log lines for viewers of robots' data; may be "
      "repeated");
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_simulate(CLI::App& app, SimulateOptions& o) {
  CLI::App* sub = command(
      app, "simulate", "run a scene of blocks as physics has it",
      "  stigc simulate scenes/pyramid.yaml\n"
      "  stigc simulate scenes/drop.yaml --duration 3 -o drop.png --at 0.4\n"
      "  stigc simulate scenes/drop.yaml --duration 1 --trace drop.stigp --checkpoint drop.stigk\n"
      "  stigc simulate --resume drop.stigk --trace drop.stigp --duration 2\n"
      "  stigc simulate scenes/stack.yaml --runs 3 --json\n");
  sub->add_option("SCENE", o.scene, "the scene; left out with --resume")->type_name("FILE");
  parsed(sub, "--seed", "N", "seed of all random choices (default: the scene's)",
         [&o](const std::string& text) { return parse_seed(text, o.seed.emplace()); });
  seconds(sub, "--duration", o.duration, "simulated seconds (default: the scene's)");
  path(sub, "--trace", o.trace, "record the run, for replay and viewers (.stigp)");
  sub->add_flag("--trace-detail", o.detail,
                "record also what robots sense and send, magnets and forces");
  path(sub, "-o,--output", o.picture, "draw the end, or the moment --at (.png)");
  moment(sub, "--at", o.at, "the picture's moment, in simulated seconds");
  sub->add_option("--camera", o.camera, "draw what this camera of a robot sees")
      ->type_name("ROBOT[:CAMERA]");
  path(sub, "--checkpoint", o.checkpoint, "write the state at the end, also when interrupted");
  path(sub, "--resume", o.resume, "go on from a checkpoint; --trace names the trace so far");
  integer(sub, "--runs", o.runs, 1, 100'000, "so many runs with seeds one after the other");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads for the runs; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

void add_describe(CLI::App& app, DescribeOptions& o) {
  CLI::App* sub = command(app, "describe", "show what a robot is made of",
                          "  stigc describe robots/bebot.yaml\n"
                          "  stigc describe robots/bebot.yaml --json\n"
                          "  stigc describe robots/bebot.yaml -o bebot.png\n");
  file(sub, "ROBOT", o.robot, "the robot's file");
  path(sub, "-o,--output", o.picture, "draw it, with what its devices reach (.png .glb)");
  sub->add_flag("--json", o.json, "print one JSON object instead of the tables");
}

void add_compile(CLI::App& app, CompileFileOptions& o) {
  CLI::App* sub =
      command(app, "compile", "turn a rule set into the controller of a robot",
              "  stigc compile rulesets/staircase.yaml\n"
              "  stigc compile rulesets/staircase.yaml -o staircase.lua --report staircase.txt\n"
              "  stigc compile rulesets/staircase.yaml --sides=+x --robot robots/builderbot.yaml\n"
              "  stigc compile rulesets/staircase.yaml --target argos -o staircase\n"
              "  stigc compile rulesets/staircase.yaml --target dot > decisions.dot\n");
  file(sub, "FILE", o.file, "the rule set; - is standard input");
  path(sub, "--robot", o.robot, "the robot's file (default: bebot.yaml, the paper's)");
  path(sub, "--block", o.block, "the block's file (default: stigmergic.yaml, the paper's)");
  add_sides(*sub, o.sides, kSidesOfRobots);
  integer(sub, "--robots", o.robots, 1, 100, "robots that work at once (default: the file's)");
  choice(sub, "--target", o.target,
         {{"table", CompileTarget::table},
          {"lua", CompileTarget::lua},
          {"argos", CompileTarget::argos},
          {"dot", CompileTarget::dot},
          {"ir", CompileTarget::ir}},
         "what to print (default: lua into a file named .lua, argos into one named .argos, "
         "otherwise table)");
  path(sub, "-o,--output", o.output,
       "write it to a file; .lua.map beside it says which lines are rules; for ARGoS "
       "NAME[.argos], beside which NAME_robot.lua and NAME_block.lua are written");
  path(sub, "--report", o.report, "write the table to a file as well");
  path(sub, "--certificate", o.certificate,
       "write why robots that follow it complete the structure, for stigc certify");
  path(sub, "--why", o.page,
       "where rules are refused, write a page that shows the brick in the way (.html)");
  seconds(sub, "--budget", o.budget,
          "seconds for the proof of the rule set (default: as much work as verify does)");
  integer(sub, "--states", o.states, 1, std::int64_t{1} << 24,
          "structures on the way that are walked at most (default: 100000)");
}

void add_validate(CLI::App& app, ValidateOptions& o) {
  CLI::App* sub = command(app, "validate", "let robots build a rule set's structure, and judge it",
                          "  stigc validate rulesets/staircase.yaml\n"
                          "  stigc validate rulesets/staircase.yaml --runs 2 -o staircase-runs\n"
                          "  stigc validate rulesets/stepped-pyramid.yaml --robots 4 --allocation "
                          "dynamic --duration 5  # exit status 1: too short\n"
                          "  stigc validate rulesets/stepped-pyramid.yaml --structures 5 --robots "
                          "20 --duration 5  # exit status 1\n"
                          "  stigc validate rulesets/staircase.yaml --scene "
                          "scenes/faults/cache-empty.yaml --duration 5  # exit status 1\n");
  file(sub, "FILE", o.file, "the rule set; - is standard input");
  integer(sub, "--structures", o.structures, 1, 25,
          "structures, each with a start and caches of its own (default: 1)");
  integer(sub, "--robots", o.robots, 1, 100,
          "robots at all structures together (default: the file's for each, or 1)");
  path(sub, "--robot", o.robot, "the robots' file (default: bebot.yaml, the paper's)");
  add_sides(*sub, o.sides, kSidesOfRobots);
  choice(
      sub, "--allocation", o.allocation,
      {{"dynamic", Allocation::dynamic_}, {"fixed", Allocation::fixed}},
      "fixed: each robot has its own sides (default); dynamic: who is obstructed goes to another");
  path(sub, "--scene", o.scene,
       "a scene with fixed start bricks, of as many structures as there are, in place of the usual "
       "set-up");
  integer(sub, "--runs", o.runs, 1, 10'000, "runs, with one seed after the other (default: 1)");
  integer(sub, "--run", o.run, 0, 10'000 - 1,
          "the run of that number alone, as --runs has it, from 0");
  parsed(sub, "--seed", "N", "seed of the first run (default: 1)",
         [&o](const std::string& text) { return parse_seed(text, o.seed); });
  seconds(sub, "--duration", o.duration,
          "simulated seconds for a run (default: 2400, or 150 a brick)");
  path(sub, "-o,--output", o.output,
       "a folder for the report, curves, traces, the scene and the controller");
  sub->add_flag("--trace-detail", o.detail,
                "record also what robots sense and send, magnets and forces");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads for the runs; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

}  // namespace stig::cli
