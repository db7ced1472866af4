// SPDX-License-Identifier: MIT
// The options of the commands that begin with a structure that is wanted.
#include "command_options.h"
#include "compiler/compile.h"
#include "option_kinds.h"
#include "sensing/led_code.h"

namespace stig::cli {
namespace {

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

/// N, or as many as a code has that survives an LED misread.
template <class Options>
void add_kinds(CLI::App* sub, Options& o, const char* text) {
  parsed(sub, "--kinds", "N|codes", text, [&o](const std::string& given) -> std::string {
    std::int64_t value = sensing::code_size(kBlockColours + 1);
    if (given != "codes" && !parse_integer(given, 1, kMaxColours, value).empty()) {
      return fmt::format("'{}' is not a number from 1 to {}, or codes", given, kMaxColours);
    }
    o.kinds = static_cast<int>(value);
    return {};
  });
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

}  // namespace

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
  file(sub, "STRUCTURE", o.target, "what to build (.vox .json .txt), or a mesh");
  lattice(sub, o.lattice);
  mesh_bricks(sub, o.mesh);
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
  path(sub, "--block", o.block, "with --robot: the block's file (default: stigmergic.yaml)");
  integer(sub, "--robots", o.robots, 1, 100,
          "with --robot: so many have to be able to work at once (default: as many as may be)");
  add_sides(*sub, o.sides,
            "with --robot: the sides that it works from, as --sides=+x,-x (default: chosen)");
  add_kinds(
      sub, o,
      "with --robot: of brick, at most; more than four are code words of blocks' LEDs: up to 16 "
      "survive one that is misread (codes: 16), up to 62 one that is missed (default: 4)");
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
  file(sub, "STRUCTURE", o.target, "what to build (.vox .json .txt), or a mesh");
  mesh_bricks(sub, o.mesh);
  integer(sub, "--robots", o.robots, 1, 100, "robots that work at once (default: 1)");
  path(sub, "--robot", o.robot, "the robots' file (default: bebot.yaml, the paper's)");
  add_sides(*sub, o.sides, "the sides that they work from, as --sides=+x,-x (default: chosen)");
  parsed(sub, "--colours", "N|given|free", "as with synth (default: free)",
         [&o](const std::string& text) { return parse_colours(text, o); });
  add_kinds(sub, o, "of brick, at most, as with synth (default: 4)");
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

}  // namespace stig::cli
