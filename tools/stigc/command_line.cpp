// SPDX-License-Identifier: MIT
// The only file that includes CLI11, which takes seconds to compile. The parser is made anew for
// each use; what it reads goes into Storage, and help, completions and suggestions are taken from
// the same declarations, so that none can be out of date. Numbers and words are read by functions
// of our own (numbers.h): CLI11's take "1e3" and " 7", and their messages are not ours.
#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <limits>

#include "base/diagnostic.h"
#include "numbers.h"

namespace stig::cli {
namespace {

/// Where the parser puts what it reads: one of each kind of options. CLI11 writes into these by
/// reference while it parses, so they must outlive the parser.
struct Storage {
  GlobalOptions global;
  std::string code;  ///< of a diagnostic
  CheckOptions check;
  FmtOptions fmt;
  ExploreOptions explore;
  ExplainOptions explain;
  TestOptions test;
  VerifyFileOptions verify;
  CertifyOptions certify;
  GraphOptions graph;
  ReplayOptions replay;
  SchemaOptions schema;
  MeasureOptions measure;
  DrawOptions draw;
  CompletionsOptions completions;
  DoctorOptions doctor;
  SynthOptions synth;
  SimulateOptions simulate;
  DescribeOptions describe;
  CompileFileOptions compile;
  ValidateOptions validate;
  BuildOptions build;
  ViewOptions view;
};

/// An option whose text is read by `parse`, which returns what is wrong.
CLI::Option* parsed(CLI::App* app, const std::string& names, const std::string& value,
                    const std::string& doc, std::function<std::string(const std::string&)> parse) {
  // The long name, if there is one: what messages call the option.
  const std::string shown = names.substr(names.rfind(',') + 1);
  return app
      ->add_option_function<std::string>(
          names,
          [parse = std::move(parse), shown](const std::string& text) {
            // What is wrong is told to CLI11 by an exception; the words are ours.
            const std::string problem = parse(text);
            if (!problem.empty()) throw CLI::ValidationError(shown, problem);
          },
          doc)
      ->type_name(value);
}

template <class Integer>
CLI::Option* integer(CLI::App* app, const std::string& names, Integer& out, std::int64_t low,
                     std::int64_t high, const std::string& doc) {
  return parsed(app, names, "N", doc, [&out, low, high](const std::string& text) {
    std::int64_t value = 0;
    const std::string problem = parse_integer(text, low, high, value);
    if (problem.empty()) {
      // An optional's value is set, a number assigned.
      if constexpr (std::is_arithmetic_v<Integer>) {
        out = static_cast<Integer>(value);
      } else {
        out = static_cast<typename Integer::value_type>(value);
      }
    }
    return problem;
  });
}

template <class Enum>
using Words = std::vector<std::pair<std::string, Enum>>;

/// One of a few words; `value` of the option lists them, parted by bars.
template <class Out, class Enum = Out>
CLI::Option* choice(CLI::App* app, const std::string& names, Out& out, const Words<Enum>& words,
                    const std::string& doc) {
  std::string value;
  for (const auto& [word, meaning] : words) value += (value.empty() ? "" : "|") + word;
  return parsed(app, names, value, doc, [&out, words](const std::string& text) -> std::string {
    std::vector<std::string_view> known;
    for (const auto& [word, meaning] : words) {
      known.push_back(word);
      if (word != text) continue;
      out = meaning;
      return {};
    }
    const std::string_view near = nearest(text, known);
    const std::string hint = near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
    return fmt::format("'{}' is not one of {}{}", text, fmt::join(known, ", "), hint);
  });
}

/// A name for a file, or for several.
CLI::Option* path(CLI::App* app, const std::string& names, std::optional<std::string>& out,
                  const std::string& doc) {
  return parsed(app, names, "FILE", doc, [&out](const std::string& text) -> std::string {
    out = text;
    return text.empty() ? "a name is wanted" : "";
  });
}

/// An option that takes one value and may be given several times.
CLI::Option* repeated(CLI::App* app, const std::string& names, std::vector<std::string>& out,
                      const std::string& value, const std::string& doc) {
  // Without allow_extra_args(false) CLI11 would take the next arguments too, up to an option.
  return app->add_option(names, out, doc)->type_name(value)->allow_extra_args(false);
}

CLI::Option* file(CLI::App* app, const std::string& name, std::string& out,
                  const std::string& doc) {
  return app->add_option(name, out, doc)->type_name(name)->required();
}

CLI::Option* files(CLI::App* app, std::vector<std::string>& out, const std::string& doc) {
  return app->add_option("FILE", out, doc)->type_name("FILE")->required();
}

// Counters of a run are 64-bit and signed, and the command line takes no more.
constexpr std::int64_t kMostCount = std::numeric_limits<std::int64_t>::max();
/// A run's number has 24 bits.
constexpr int kMostRuns = 1 << 24;

void add_global(CLI::App& app, GlobalOptions& o) {
  choice(&app, "--diagnostics", o.json_diagnostics, {{"text", false}, {"json", true}},
         "how problems in files are reported: for people, or as a JSON array");
  choice(&app, "--color", o.color,
         {{"auto", Coloured::automatic}, {"always", Coloured::always}, {"never", Coloured::never}},
         "colours in messages; auto: on a terminal, unless NO_COLOR is set");
  // CLI11 has no option "-W error" with one fixed word, hence an option with one value.
  parsed(&app, "-W", "error", "-W error: warnings count as errors",
         [&o](const std::string& text) -> std::string {
           if (text != "error") return fmt::format("'{}' is not 'error'", text);
           o.warnings_are_errors = true;
           return {};
         });
  app.add_flag("--werror", o.warnings_are_errors, "the same as -W error");
  app.add_flag("-q,--quiet", o.quiet, "no progress and no remarks on standard error");
}

CLI::App* command(CLI::App& app, const std::string& name, const std::string& summary,
                  const std::string& examples) {
  // With fallthrough, global options may stand behind the command.
  CLI::App* sub = app.add_subcommand(name, summary)->fallthrough();
  sub->footer(examples);
  return sub;
}

// tests/stigc/help_test.cpp runs the examples of every help: each has to work as it stands.
void add_check(CLI::App& app, CheckOptions& o) {
  CLI::App* sub =
      command(app, "check", "report every problem of rule sets, scenes, robots and blocks",
              "  stigc check rulesets/staircase.yaml scenes/drop.yaml robots/bebot.yaml\n"
              "  stigc check --diagnostics json rulesets/staircase.yaml > problems.json\n"
              "  stigc check -W error rulesets/staircase.yaml\n");
  files(sub, o.files, "rule sets, scenes, robots or blocks to check; - is standard input");
}

void add_fmt(CLI::App& app, FmtOptions& o) {
  CLI::App* sub = command(app, "fmt", "print rule sets in canonical form, comments kept",
                          "  stigc fmt rulesets/staircase.yaml > mine.yaml\n"
                          "  stigc fmt --check mine.yaml\n"
                          "  stigc fmt --write mine.yaml\n");
  files(sub, o.files, "rule sets to print; - is standard input");
  CLI::Option* write = sub->add_flag("--write", o.write, "rewrite the files in place");
  sub->add_flag("--check", o.check, "write nothing; exit 1 when a file is not in canonical form")
      ->excludes(write);
}

/// --box, --origin and --periodic; `doc` is that of --box.
void world(CLI::App* sub, WorldOptions& out, const std::string& doc) {
  // "none" leaves `box` set but without a size: unbounded space is a choice, no default.
  parsed(sub, "--box", "X,Y,Z", doc, [&out](const std::string& text) -> std::string {
    BoxOption& box = out.box.emplace();
    return text == "none" ? "" : parse_size(text, box.size.emplace());
  });
  parsed(sub, "--origin", "X,Y,Z",
         "the lowest cell of the box, given here or in the file (default: where the file says for "
         "its own, else such that the start is in the middle)",
         [&out](const std::string& text) { return parse_cell(text, out.origin.emplace()); });
  sub->add_flag("--periodic", out.periodic, "the sides of the box wrap around");
}

void add_explore_swarm(CLI::App* sub, ExploreOptions& o) {
  choice(sub, "--motion", o.motion,
         {{"walk", Motion::walk}, {"teleport", Motion::teleport}, {"event", Motion::event}},
         "how agents move; event: no agents, a random order of events (default: walk)");
  integer(sub, "--agents", o.agents, 1, std::numeric_limits<int>::max(),
          "number of agents (default: 10)");
  // At once and in order, as several values are put into one list.
  parsed(sub, "--agents-at", "X,Y,Z",
         "where the first agents start, the others anywhere; may be repeated",
         [&o](const std::string& text) { return parse_cells(text, o.agents_at); })
      ->allow_extra_args(false)
      ->trigger_on_parse();
  integer(sub, "--moves", o.moves, 6, 26,
          "neighbours an agent steps to: 6, 18 or 26; hexagonal 8 or 20 (default: the most)");
  world(sub, o.world,
        "size of the world, laid around the start, or none for unbounded space (event motion "
        "alone); default: the file's box, else 20,20,20 for agents and none for events");
}

void add_explore(CLI::App& app, ExploreOptions& o) {
  CLI::App* sub = command(
      app, "explore", "run a swarm on a rule set and see what it builds",
      "  stigc explore rulesets/staircase.yaml\n"
      "  stigc explore rulesets/staircase.yaml -o staircase.png -o staircase.glb\n"
      "  stigc explore rulesets/architecture-4n.yaml --motion event --seed 7 --json\n"
      "  stigc explore rulesets/tiling.yaml --motion event --deposits 5000 -o tiling.vox\n"
      "  stigc explore rulesets/wall.yaml --runs 10 --threads 0 -o runs.csv -o 'wall-{run}.txt'\n"
      "  stigc explore rulesets/staircase.yaml --trace run.stigt && stigc replay run.stigt\n");
  file(sub, "FILE", o.file, "the rule set; - is standard input");
  add_explore_swarm(sub, o);
  // 2^43 steps: random streams count steps in blocks, see base/random.h and lattice/swarm.cpp.
  integer(sub, "--steps", o.steps, 0, (std::int64_t{1} << 43) - 1,
          "stop after so many steps (default: 10000000 for agents, unless --deposits is given)");
  integer(sub, "--deposits", o.deposits, 0, kMostCount,
          "stop after so many deposits (default: 100000 in unbounded space, unless --steps is "
          "given)");
  parsed(sub, "--seed", "N", "seed of all random choices (default: 1)",
         [&o](const std::string& text) { return parse_seed(text, o.seed); });
  integer(sub, "--runs", o.runs, 1, kMostRuns, "so many runs, each with its own random numbers");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads for the runs; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
  repeated(sub, "-o,--output", o.outputs, "FILE",
           "write the structure, in the format of the ending: .vox .stl .ply .glb .png .svg .json "
           ".txt; .csv the log of deposits, or with --runs the table of runs; .stigt a trace. May "
           "be repeated; with --runs, {run} in a structure's name is the number of the run");
  path(sub, "--trace", o.trace, "write a trace of the run, for replay");
}

void add_explain(CLI::App& app, ExplainOptions& o) {
  CLI::App* sub =
      command(app, "explain", "say of each rule why it fires at a site, or why not",
              "  stigc explain rulesets/staircase.yaml --at 1,0,0\n"
              "  stigc explore rulesets/staircase.yaml --deposits 1 -o half-built.txt\n"
              "  stigc explain rulesets/staircase.yaml --structure half-built.txt --at 1,0,1\n"
              "  stigc explain rulesets/architecture-4n.yaml --at 0,1,0 --stage 2 --json\n");
  file(sub, "FILE", o.file, "the rule set");
  path(sub, "--structure", o.structure, "structure file (default: the rule set's start)");
  parsed(sub, "--at", "X,Y,Z", "the site", [&o](const std::string& text) {
    return parse_cell(text, o.at);
  })->required();
  integer(sub, "--stage", o.stage, 1, 1000000, "the stage that rules are in (default: 1)");
  integer(sub, "--rule", o.rule, 1, 1000000, "the N-th rule alone");
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_test(CLI::App& app, TestOptions& o) {
  CLI::App* sub = command(app, "test", "hold rule sets to what they expect of themselves",
                          "  stigc test rulesets/staircase.yaml rulesets/wall.yaml\n"
                          "  stigc test --states 20000000 rulesets/plate.yaml\n");
  files(sub, o.files, "rule sets with an 'expect' entry");
  integer(sub, "--samples", o.samples, 1, 1 << 24,
          "orders of events sampled before all are tried (default: 64)");
  integer(sub, "--states", o.states, 0, kMostCount,
          "states visited at most when every order is tried (default: 2000000)");
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_sides(CLI::App& sub, std::vector<std::string>& sides, const char* what) {
  // Sides may be given as one list. The words are tested by CLI11 itself.
  sub.add_option("--sides", sides, what)
      ->type_name("SIDE")
      ->expected(1, 4)
      ->delimiter(',')  // "--sides -x" would be an option -x
      ->check(CLI::IsMember({"+x", "-x", "+y", "-y"}));
}

constexpr const char* kSidesOfRobots =
    "the sides that robots work from, in place of the file's, as --sides=+x,-x; of symmetric rules "
    "those turns hold that these sides have";
constexpr const char* kTurnsOfSides =
    "of symmetric rules, the turns alone that robots at these sides follow, as --sides=+x,-x; +x: "
    "as written";

CLI::Option* seconds(CLI::App* app, const std::string& names, std::optional<double>& out,
                     const std::string& doc) {
  return parsed(app, names, "S", doc,
                [&out](const std::string& text) { return parse_seconds(text, out.emplace()); });
}

constexpr const char* kWorldThatIsMeant =
    "the world that is meant, a size laid around the start, or none for unbounded space (default: "
    "the file's box, else none)";

void add_verify(CLI::App& app, VerifyFileOptions& o) {
  CLI::App* sub =
      command(app, "verify", "prove that every order of events ends alike, or refute it",
              "  stigc verify rulesets/staircase.yaml --certificate staircase.cert\n"
              "  stigc certify rulesets/staircase.yaml staircase.cert\n"
              "  stigc verify rulesets/wall.yaml --box none --effort 5 --json\n"
              "  stigc verify rulesets/order-dependent.yaml --witness two-ends  # exit status 1: "
              "refuted\n");
  file(sub, "FILE", o.file, "the rule set; - is standard input");
  world(sub, o.world, kWorldThatIsMeant);
  add_sides(*sub, o.sides, kTurnsOfSides);
  parsed(sub, "--effort", "E",
         "how much is tried before the verdict is 'unknown'; 1 is a minute at most on a machine of "
         "2020, and ten seconds more for what else there is to say; the same effort gives the same "
         "output (default: 1)",
         [&o](const std::string& text) { return parse_effort(text, o.effort); });
  seconds(sub, "--budget", o.budget,
          "seconds after which the verdict is 'unknown' whatever the effort (default: no limit)");
  integer(sub, "--states", o.states, 1, std::int64_t{1} << 31,
          "fillings of a group of bricks kept at most (default: 2000000)");
  path(sub, "--certificate", o.certificate, "write the certificate of a proof");
  path(sub, "--witness", o.witness,
       "write what shows the verdict: traces and pictures whose names begin with this")
      ->type_name("NAME");
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_certify(CLI::App& app, CertifyOptions& o) {
  CLI::App* sub = command(
      app, "certify", "check a proof again, without trust in its maker",
      "  stigc verify rulesets/staircase.yaml --certificate staircase.cert\n"
      "  stigc certify rulesets/staircase.yaml staircase.cert\n"
      "  stigc explore rulesets/stepped-pyramid.yaml -o pyramid.txt\n"
      "  stigc synth pyramid.txt --proof proof -o pyramid.yaml && stigc certify --fewest proof\n"
      "  stigc certify --drat proof/fewer.cnf proof/fewer.drat\n");
  file(sub, "FILE", o.file, "the rule set; with --drat, a formula (DIMACS CNF)");
  sub->add_option("PROOF", o.proof,
                  "its certificate; with --drat, a proof that the formula has no solution")
      ->type_name("PROOF");
  sub->add_flag("--fewest", o.fewest,
                "FILE is the folder that synth --proof wrote: is it true that fewer colours do not "
                "do in this order?");
  sub->add_flag("--drat", o.drat, "a formula and its DRAT proof, text or binary");
  world(sub, o.world, kWorldThatIsMeant);
  add_sides(*sub, o.sides, kTurnsOfSides);
  sub->add_flag("--json", o.json, "print one JSON object");
}

void lattice(CLI::App* sub, std::optional<Lattice>& out) {
  choice<std::optional<Lattice>, Lattice>(
      sub, "--lattice", out, {{"cubic", Lattice::cubic}, {"hexagonal", Lattice::hexagonal}},
      "the lattice of a file that does not say it, as no .vox does (default: cubic)");
}

void add_replay(CLI::App& app, ReplayOptions& o) {
  CLI::App* sub = command(
      app, "replay", "look at a recorded run, or run it again and compare",
      "  stigc explore rulesets/staircase.yaml --trace run.stigt && stigc replay run.stigt\n"
      "  stigc simulate scenes/drop.yaml --trace drop.stigp && stigc replay drop.stigp\n"
      "  stigc replay drop.stigp --at 1.5 -o drop.png\n"
      "  stigc replay drop.stigp --verify\n");
  file(sub, "TRACE", o.trace, "trace of explore, which is run again, or of simulate");
  sub->add_flag("--verify", o.verify,
                "run the scene again and compare the hashes of its states; traces of explore "
                "always are");
  seconds(sub, "--at", o.at, "the moment to show, in simulated seconds (default: the end)");
  path(sub, "-o,--output", o.picture, "draw that moment (.png)");
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
  path(sub, "-o,--output", o.picture, "draw the end, or the moment --at (.png)");
  seconds(sub, "--at", o.at, "the picture's moment, in simulated seconds");
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
                          "  stigc validate rulesets/staircase.yaml --scene "
                          "scenes/faults/cache-empty.yaml --duration 5  # exit status 1\n");
  file(sub, "FILE", o.file, "the rule set; - is standard input");
  integer(sub, "--robots", o.robots, 1, 100, "robots (default: the file's, or 1)");
  path(sub, "--robot", o.robot, "the robots' file (default: bebot.yaml, the paper's)");
  add_sides(*sub, o.sides, kSidesOfRobots);
  choice(
      sub, "--allocation", o.allocation,
      {{"dynamic", Allocation::dynamic_}, {"fixed", Allocation::fixed}},
      "fixed: each robot has its own sides (default); dynamic: who is obstructed goes to another");
  path(sub, "--scene", o.scene, "a scene with fixed start bricks, in place of the usual set-up");
  integer(sub, "--runs", o.runs, 1, 10'000, "runs, with one seed after the other (default: 1)");
  parsed(sub, "--seed", "N", "seed of the first run (default: 1)",
         [&o](const std::string& text) { return parse_seed(text, o.seed); });
  seconds(sub, "--duration", o.duration,
          "simulated seconds for a run (default: 2400, or 150 a brick)");
  path(sub, "-o,--output", o.output,
       "a folder for the report, curves, traces, the scene and the controller");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads for the runs; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
}

// Commands that print what others write: small, so they share a function.
void add_files_out(CLI::App& app, Storage& s) {
  CLI::App* graph = command(app, "graph", "print which rule's brick another rule can need, as DOT",
                            "  stigc graph rulesets/staircase.yaml > staircase.dot\n");
  file(graph, "FILE", s.graph.file, "the rule set");
  add_replay(app, s.replay);
  CLI::App* schema =
      command(app, "schema", "print the JSON Schema of rule set, scene, robot or block files",
              "  stigc schema > stigc.schema.json\n"
              "  stigc schema --symbols-of rulesets/staircase.yaml > staircase.schema.json\n"
              "  stigc schema scene > scene.schema.json\n");
  choice(schema, "FORM", s.schema.form,
         {{"rules", FileForm::rules},
          {"scene", FileForm::scene},
          {"robot", FileForm::robot},
          {"block", FileForm::block}},
         "what kind of file (default: rules)");
  path(schema, "--symbols-of", s.schema.symbols_of,
       "a rule set, finished or not, whose symbols editors shall offer where one is wanted");
  CLI::App* measure = command(
      app, "measure", "measure a structure file",
      "  stigc explore rulesets/staircase.yaml -o staircase.vox && stigc measure staircase.vox\n"
      "  stigc explore rulesets/tiling.yaml -o tiling.vox\n"
      "  stigc measure tiling.vox --lattice hexagonal --json\n");
  file(measure, "STRUCTURE", s.measure.structure, "structure file (.vox .json .txt)");
  lattice(measure, s.measure.lattice);
  measure->add_flag("--json", s.measure.json, "print one JSON object");
  CLI::App* draw = command(app, "draw", "draw a structure file, or turn it into another format",
                           "  stigc explore rulesets/staircase.yaml -o staircase.vox\n"
                           "  stigc draw staircase.vox -o staircase.png\n"
                           "  stigc draw staircase.vox -o staircase.glb -o staircase.stl\n");
  file(draw, "STRUCTURE", s.draw.structure, "structure file (.vox .json .txt)");
  lattice(draw, s.draw.lattice);
  repeated(draw, "-o,--output", s.draw.outputs, "FILE",
           "file to write, in the format of its ending; may be repeated")
      ->required();
}

/// N, or one of two words. Both kinds of options have `colours` and `use`: synth's and build's.
template <class Options>
std::string parse_colours(const std::string& text, Options& o) {
  // The last one given counts: an earlier number must not stay behind a later word.
  o.colours.reset();
  o.use = text == "given" ? ColourUse::given : ColourUse::free;
  if (text == "given" || text == "free") return {};
  std::int64_t value = 0;
  const std::string problem = parse_integer(text, 1, kMaxColours, value);
  if (problem.empty()) o.colours = static_cast<int>(value);
  return problem.empty()
             ? ""
             : fmt::format("'{}' is not a number from 1 to {}, given or free", text, kMaxColours);
}

void add_synth_search(CLI::App* sub, SynthOptions& o) {
  choice(sub, "--fewest", o.fewest, {{"colours", Fewest::colours}, {"rules", Fewest::rules}},
         "what there is to be little of (default: colours)");
  choice<std::optional<OrderFamily>, OrderFamily>(
      sub, "--order", o.family,
      {{"breadth-first", OrderFamily::breadth_first},
       {"raster", OrderFamily::raster},
       {"ribbons", OrderFamily::ribbons},
       {"crowded", OrderFamily::crowded}},
      "orders of placement that are tried (default: all)");
  sub->add_flag("--strict", o.strict, "no ties in the order, but for what the symmetry maps");
  integer(sub, "--scaffold", o.scaffold, 0, 1000000,
          "so many cells may be added beside straight runs, which can then count in fewer colours");
  sub->add_flag("--exact", o.exact, "one rule for each neighbourhood, none merged");
  // Effort is a count of work and no time, so that machines of any speed find the same.
  integer(sub, "--effort", o.effort, 1, 1000000,
          "how much is tried, in units of some 20 seconds at most on a machine of 2020; the same "
          "effort gives the same result (default: 1)");
  integer(sub, "--budget", o.seconds, 1, 1000000,
          "seconds after which the search ends with what it has, and says so (default: 300)");
}

void add_synth(CLI::App& app, SynthOptions& o) {
  CLI::App* sub = command(
      app, "synth", "compile a structure into a rule set that builds it in every order",
      "  stigc explore rulesets/stepped-pyramid.yaml -o pyramid.txt\n"
      "  stigc synth pyramid.txt -o pyramid.yaml\n"
      "  stigc synth pyramid.txt --colours given --floor -o as-drawn.yaml\n"
      "  stigc synth pyramid.txt --symmetry rotations --fewest rules -o turned.yaml\n"
      "  stigc synth pyramid.txt --order breadth-first --proof proof -o proved.yaml --json\n"
      "  stigc synth pyramid.txt --robot robots/bebot.yaml -o followed.yaml\n"
      "  stigc compile followed.yaml\n");
  file(sub, "STRUCTURE", o.target, "what to build (.vox .json .txt)");
  lattice(sub, o.lattice);
  parsed(sub, "--colours", "N|given|free",
         "free: any colours, the fewest (default); N: at most so many; given: those of the file, "
         "where a brick with the symbol ? or # may have any",
         [&o](const std::string& text) { return parse_colours(text, o); });
  choice(sub, "--symmetry", o.symmetry,
         {{"none", Symmetry::none},
          {"rotations", Symmetry::rotations},
          {"rotations+mirrors", Symmetry::rotations_mirrors}},
         "of the rules; the target must have it about the start (default: none)");
  parsed(sub, "--start", "X,Y,Z",
         "where the first brick is; may be repeated for several (default: chosen)",
         [&o](const std::string& text) { return parse_cells(text, o.start); })
      ->allow_extra_args(false)
      ->trigger_on_parse();
  sub->add_flag("--floor", o.floor, "cells below z = 0 look like floor to the rules");
  path(sub, "--robot", o.robot,
       "a robot's file: only rules that stigc compile accepts for it, in an order that it can "
       "follow");
  integer(sub, "--robots", o.robots, 1, 100,
          "with --robot: so many have to be able to work at once (default: as many as may be)");
  add_sides(*sub, o.sides,
            "with --robot: the sides that it works from, as --sides=+x,-x (default: chosen)");
  add_synth_search(sub, o);
  path(sub, "-o,--output", o.output, "the rule set (default: standard output)");
  path(sub, "--certificate", o.certificate,
       "why every order of events builds it, for stigc certify");
  path(sub, "--proof", o.proof,
       "folder for the proof that one colour fewer does not do under this order")
      ->type_name("FOLDER");
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_build(CLI::App& app, BuildOptions& o) {
  CLI::App* sub =
      command(app, "build", "let robots build a drawing: synth --robot, compile and validate",
              "  stigc explore rulesets/staircase.yaml -o staircase.txt\n"
              "  stigc build staircase.txt -o built\n"
              "  stigc build staircase.txt --robots 2 --seed 7 -o built-by-two\n");
  file(sub, "STRUCTURE", o.target, "what to build (.vox .json .txt)");
  integer(sub, "--robots", o.robots, 1, 100, "robots that work at once (default: 1)");
  path(sub, "--robot", o.robot, "the robots' file (default: bebot.yaml, the paper's)");
  add_sides(*sub, o.sides, "the sides that they work from, as --sides=+x,-x (default: chosen)");
  parsed(sub, "--colours", "N|given|free", "as with synth (default: free)",
         [&o](const std::string& text) { return parse_colours(text, o); });
  parsed(sub, "--start", "X,Y,Z", "where the first brick is (default: chosen)",
         [&o](const std::string& text) { return parse_cells(text, o.start); });
  integer(sub, "--effort", o.effort, 1, 1000000, "how much synth tries (default: 1)");
  integer(sub, "--budget", o.seconds, 1, 1000000,
          "seconds after which synth ends with what it has (default: 300)");
  integer(sub, "--runs", o.runs, 1, 10'000, "runs, with one seed after the other (default: 1)");
  parsed(sub, "--seed", "N", "seed of the first run (default: 1)",
         [&o](const std::string& text) { return parse_seed(text, o.seed); });
  seconds(sub, "--duration", o.duration, "simulated seconds for a run (default: as validate)");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads for the runs; 0: all cores (default). The results are the same for any");
  sub->add_option("-o,--output", o.output,
                  "a folder for the rules, the decisions, pictures, and what validate writes")
      ->type_name("FOLDER")
      ->required();
}

void add_view(CLI::App& app, ViewOptions& o) {
  CLI::App* sub = command(
      app, "view", "make a page that shows structures and runs in 3-D, in any browser",
      "  stigc explore rulesets/staircase.yaml --trace run.stigt && stigc view run.stigt -o "
      "run.html\n"
      "  stigc explore rulesets/tiling.yaml --motion event --deposits 500 -o tiling.json\n"
      "  stigc view tiling.json -o tiling.html\n"
      "  stigc verify rulesets/order-dependent.yaml --witness two  # exit status 1: refuted\n"
      "  stigc view two -o two-ends.html\n"
      "  stigc simulate scenes/drop.yaml --duration 1 --trace drop.stigp\n"
      "  stigc view drop.stigp -o drop.html\n");
  sub->add_option("FILE", o.files,
                  "a structure file (.vox .json .txt), a trace (.stigt .stigp), a folder of "
                  "validate, or the name that verify --witness was given; several are shown "
                  "together")
      ->type_name("FILE")
      ->required();
  sub->add_option("-o,--output", o.output, "the page, .html; nothing else is needed to open it")
      ->type_name("FILE")
      ->required();
  path(sub, "--title", o.title, "what the page is called (default: the first file's title)")
      ->type_name("TEXT");
  lattice(sub, o.lattice);
}

void add_about_itself(CLI::App& app, Storage& s) {
  CLI::App* completions =
      command(app, "completions", "print a completion script for a shell",
              "  source <(stigc completions bash)\n"
              "  mkdir -p ~/.zfunc && stigc completions zsh > ~/.zfunc/_stigc\n"
              "  mkdir -p ~/.config/fish/completions\n"
              "  stigc completions fish > ~/.config/fish/completions/stigc.fish\n");
  choice(completions, "SHELL", s.completions.shell,
         {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}}, "the shell")
      ->required();
  CLI::App* doctor = command(app, "doctor", "look at the surroundings the program runs in",
                             "  stigc doctor\n"
                             "  stigc doctor rulesets/staircase.yaml\n");
  doctor->add_option("FILE", s.doctor.files, "rule sets to check as well")->type_name("FILE");
  doctor->add_flag("--json", s.doctor.json, "print one JSON object");
}

// Looked for by name after parsing, as it replaces a command.
constexpr const char* kExplain = "--explain";

void build(CLI::App& app, Storage& s) {
  app.name("stigc");
  // None is an error too, but not CLI11's: the message is made below, in our words.
  app.require_subcommand(0, 1);
  app.set_help_flag("-h,--help", "this help, or that of a command, with examples");
  app.set_version_flag("--version", "stigc " STIG_VERSION, "the version of the program");
  app.add_option(kExplain, s.code,
                 "what a diagnostic's code means, with an example; without CODE: all codes")
      ->type_name("[CODE]")
      ->expected(0, 1);
  add_global(app, s.global);
  add_check(app, s.check);
  add_fmt(app, s.fmt);
  add_explore(app, s.explore);
  add_explain(app, s.explain);
  add_test(app, s.test);
  add_verify(app, s.verify);
  add_certify(app, s.certify);
  add_files_out(app, s);
  add_synth(app, s.synth);
  add_simulate(app, s.simulate);
  add_describe(app, s.describe);
  add_compile(app, s.compile);
  add_validate(app, s.validate);
  add_build(app, s.build);
  add_view(app, s.view);
  add_about_itself(app, s);
}

// What help and completions know of an option comes from CLI11's own record of it.
OptionInfo describe(const CLI::Option& option) {
  OptionInfo info;
  for (const auto& name : option.get_snames()) info.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) info.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) info.value = option.get_type_name();
  info.doc = option.get_description();
  // Flags expect no value, lists more than one.
  info.many = option.get_items_expected_max() > 1;
  info.required = option.get_required();
  return info;
}

/// Positional arguments first, then options in the order they were added; --help last.
std::vector<OptionInfo> describe_options(const CLI::App& app) {
  std::vector<OptionInfo> positional, named;
  for (const CLI::Option* option : app.get_options()) {
    if (option == app.get_help_ptr()) continue;
    (option->get_positional() ? positional : named).push_back(describe(*option));
  }
  positional.insert(positional.end(), named.begin(), named.end());
  if (app.get_help_ptr() != nullptr) positional.push_back(describe(*app.get_help_ptr()));
  return positional;
}

CommandInfo describe_command(const CLI::App& sub) {
  return {sub.get_name(), sub.get_description(), sub.get_footer(), describe_options(sub)};
}

// The options of the command that was given, out of all that Storage has. The list copies each; a
// command line is read once.
CommandOptions chosen(const std::string& name, const Storage& s) {
  const std::vector<std::pair<std::string_view, CommandOptions>> all = {
      {"check", s.check},       {"fmt", s.fmt},           {"explore", s.explore},
      {"explain", s.explain},   {"test", s.test},         {"verify", s.verify},
      {"certify", s.certify},   {"graph", s.graph},       {"replay", s.replay},
      {"schema", s.schema},     {"measure", s.measure},   {"draw", s.draw},
      {"synth", s.synth},       {"doctor", s.doctor},     {"completions", s.completions},
      {"simulate", s.simulate}, {"describe", s.describe}, {"compile", s.compile},
      {"validate", s.validate}, {"build", s.build},       {"view", s.view}};
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == name; });
  return found->second;
}

/// "; did you mean '--box'?" for an argument that nothing knows, or nothing.
std::string suggestion(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  // Options of the program and of the command that was given are offered, and commands where none
  // was.
  const auto add_options = [&](const CLI::App& of) {
    for (const OptionInfo& option : describe_options(of)) {
      names.insert(names.end(), option.names.begin(), option.names.end());
    }
  };
  add_options(app);
  const auto parsed_commands = app.get_subcommands();
  for (const CLI::App* sub : parsed_commands) add_options(*sub);
  if (parsed_commands.empty()) {
    for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  }
  const std::string_view near = nearest(word, {names.begin(), names.end()});
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

/// Is there a word where a command would be? Then help of it is not to be had.
bool unknown_command(const CLI::App& app) {
  return app.get_subcommands().empty() && !app.remaining(true).empty();
}

std::string unknown_word(const CLI::App& app, const std::string& word, const char* unless_option) {
  const char* what = word.starts_with("-") ? "unknown option" : unless_option;
  return fmt::format("{} '{}'{}", what, word, suggestion(app, word));
}

std::string problem_in_words(const CLI::App& app, const CLI::ParseError& error) {
  // What CLI11 could not place, in the order of the command line.
  const std::vector<std::string> extra = app.remaining(true);
  if (app.get_subcommands().empty()) {
    return extra.empty() ? "a command is wanted"
                         : unknown_word(app, extra.front(), "there is no command");
  }
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extra.empty()) {
    return unknown_word(app, extra.front(), "unexpected argument");
  }
  const std::string text = error.what();
  // CLI11 counts values, a user options: "At Most 1 required but received 2" says less than the
  // words here.
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr &&
      text.find("At Most") != std::string::npos) {
    return text.substr(0, text.find(':')) + " is given more than once";
  }
  return text;
}

}  // namespace

CommandTree command_tree() {
  CLI::App app;
  Storage storage;
  build(app, storage);
  CommandTree tree;
  tree.global = describe_options(app);
  for (const CLI::App* sub : app.get_subcommands({})) {
    tree.commands.push_back(describe_command(*sub));
  }
  return tree;
}

Parsed parse_command_line(int argc, const char* const* argv) {
  CLI::App app;
  Storage storage;
  build(app, storage);
  Parsed result;
  try {
    app.parse(argc, argv);
    if (app.count(kExplain) > 0) {
      result.explain = storage.code;
    } else if (app.get_subcommands().empty()) {
      result.problem = "a command is wanted";
    } else {
      result.command = app.get_subcommands().front()->get_name();
      // The parser's references end with this function: what was read leaves by value.
      result.line = CommandLine{storage.global, chosen(result.command, storage)};
    }
  } catch (const CLI::ParseError& error) {
    const auto commands = app.get_subcommands();
    if (!commands.empty()) result.command = commands.front()->get_name();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && app.count(kExplain) > 0) {
      // The code stands where the command's file would, which CLI11 then misses.
      result.explain = storage.code;  // "stigc check --explain R304": of no file
    } else if (error.get_exit_code() != 0 || unknown_command(app)) {
      result.problem = problem_in_words(app, error);
    } else {
      // Help and version are "errors" without an exit code.
      const bool version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
      result.help = version ? "stigc " STIG_VERSION "\n" : "help";
    }
  }
  return result;
}

}  // namespace stig::cli
