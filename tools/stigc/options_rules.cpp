// SPDX-License-Identifier: MIT
// The options of the commands about rule sets and what swarms build with them. Defaults in the
// documentation are those of options.h, or are said to depend on something; a test compares the
// help with a golden file.
#include "command_options.h"
#include "option_kinds.h"

namespace stig::cli {
namespace {

constexpr const char* kWorldThatIsMeant =
    "the world that is meant, a size laid around the start, or none for unbounded space (default: "
    "the file's box, else none)";

/// For verify and certify, which are about rules and know no robot: --sides leaves turns out.
constexpr const char* kTurnsOfSides =
    "of symmetric rules, the turns alone that robots at these sides follow, as --sides=+x,-x; +x: "
    "as written";

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

}  // namespace

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

void add_explore(CLI::App& app, ExploreOptions& o) {
  CLI::App* sub = command(
      app, "explore", "run a swarm on a rule set and see what it builds",
      "  stigc explore rulesets/staircase.yaml\n"
      "  stigc explore rulesets/staircase.yaml -o staircase.png -o staircase.glb\n"
      "  stigc explore rulesets/architecture-4n.yaml --motion event --seed 7 --json\n"
      "  stigc explore rulesets/tiling.yaml --motion event --deposits 5000 -o tiling.vox\n"
      "  stigc explore rulesets/wall.yaml --runs 10 --threads 0 -o runs.csv -o 'wall-{run}.txt'\n"
      "  stigc explore rulesets/wall.yaml --runs 10 -o runs.jsonl  # goes on if it was killed\n"
      "  stigc explore rulesets/wall.yaml --run 7 -o seventh.png\n"
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
  integer(sub, "--run", o.run, 0, kMostRuns - 1,
          "the run of that number alone, as --runs has it, from 0");
  integer(sub, "--threads", o.threads, 0, 4096,
          "threads for the runs; 0: all cores (default). The results are the same for any");
  sub->add_flag("--json", o.json, "print one JSON object instead of the summary");
  repeated(sub, "-o,--output", o.outputs, "FILE",
           "write the structure, in the format of the ending: .vox .stl .ply .glb .png .svg .json "
           ".txt; .csv the log of deposits, or with --runs the table of runs; .jsonl the records "
           "of --runs, a JSON object each; .stigt a trace. May "
           "be repeated; with --runs, {run} in a structure's name is the number of the run");
  palette(sub, o.palette);
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

void add_verify(CLI::App& app, VerifyFileOptions& o) {
  CLI::App* sub =
      command(app, "verify", "prove that every order of events ends alike, or refute it",
              "  stigc verify rulesets/staircase.yaml --certificate staircase.cert\n"
              "  stigc certify rulesets/staircase.yaml staircase.cert\n"
              "  stigc verify rulesets/wall.yaml --box none --effort 5 --json\n"
              "  stigc verify rulesets/staircase.yaml --losses\n"
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
  sub->add_flag("--losses", o.losses,
                "where that is proved, also whether every order of events mends the loss of a "
                "brick; looks at 200000 structures at most, or --states where that is less; exit "
                "status 1 where one does not");
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
      "  stigc compile rulesets/staircase.yaml --certificate staircase-work.cert\n"
      "  stigc certify rulesets/staircase.yaml staircase-work.cert\n"
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
  path(sub, "--robot", o.robot,
       "of a certificate that compile wrote: the robot's file (default: bebot.yaml)");
  path(sub, "--block", o.block, "and the block's file (default: stigmergic.yaml)");
  sub->add_flag("--drat", o.drat, "a formula and its DRAT proof, text or binary");
  world(sub, o.world, kWorldThatIsMeant);
  add_sides(*sub, o.sides, kTurnsOfSides);
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_graph(CLI::App& app, GraphOptions& o) {
  CLI::App* sub = command(app, "graph", "print which rule's brick another rule can need, as DOT",
                          "  stigc graph rulesets/staircase.yaml > staircase.dot\n");
  file(sub, "FILE", o.file, "the rule set");
}

void add_schema(CLI::App& app, SchemaOptions& o) {
  CLI::App* sub =
      command(app, "schema",
              "print the JSON Schema of rule set, scene, robot, block, search or study files",
              "  stigc schema > stigc.schema.json\n"
              "  stigc schema --symbols-of rulesets/staircase.yaml > staircase.schema.json\n"
              "  stigc schema scene > scene.schema.json\n");
  choice(sub, "FORM", o.form,
         {{"rules", FileForm::rules},
          {"scene", FileForm::scene},
          {"robot", FileForm::robot},
          {"block", FileForm::block},
          {"solid", FileForm::solid},
          {"search", FileForm::search},
          {"sweep", FileForm::sweep}},
         "what kind of file (default: rules)");
  path(sub, "--symbols-of", o.symbols_of,
       "a rule set, finished or not, whose symbols editors shall offer where one is wanted");
}

void add_init(CLI::App& app, InitOptions& o) {
  CLI::App* sub = command(app, "init", "start a project of one's own in a folder",
                          "  stigc init mine && cat mine/README.md\n"
                          "  cd mine && stigc check rules.yaml scene.yaml\n");
  sub->add_option("FOLDER", o.folder, "where its files go; made if it is not there")
      ->type_name("FOLDER")
      ->required();
}

void add_import(CLI::App& app, ImportOptions& o) {
  CLI::App* sub = command(
      app, "import",
      "turn a published table of rules into a rule set, URDF or SDF into a robot or a scene",
      "  printf '0,0,0,0,0,0,1 0,0,0,0,0,0 0,0,0,0,0,0,0 2 1.0\\n' > mast.txt\n"
      "  printf '0,0,0,0,0,0,2 0,0,0,0,0,0 0,0,0,0,0,0,0 1 1.0\\n' >> mast.txt\n"
      "  stigc import mast.txt -o mast.yaml && stigc explore mast.yaml --box 5,5,9\n"
      "  stigc import mast.txt --symmetry none --inversion | stigc check -\n"
      "  stigc import robots/rover.urdf -o rover.yaml && stigc describe rover.yaml\n"
      "  stigc import scenes/yard.sdf -o yard.yaml && stigc simulate yard.yaml\n");
  file(sub, "FILE", o.table,
       "the table as text, or a robot or world as XML (.urdf, .sdf); - is standard input");
  choice(sub, "--format", o.reading.form,
         {{"matrices", TableForm::matrices},
          {"slices", TableForm::slices},
          {"lines", TableForm::lines}},
         "how it is written: three slices side by side, a line for each slice, or a line for each "
         "rule (default: by its first line)");
  choice(sub, "--lattice", o.reading.matrices_of,
         {{"cubic", Lattice::cubic}, {"hexagonal", Lattice::hexagonal}},
         "of matrices; the other forms are hexagonal (default: cubic)");
  choice(sub, "--symmetry", o.reading.symmetry,
         {{"none", Symmetry::none},
          {"rotations", Symmetry::rotations},
          {"rotations+mirrors", Symmetry::rotations_mirrors}},
         "turns in which every rule holds (default: rotations)");
  sub->add_flag("--inversion", o.reading.inversion, "every rule holds upside down too");
  path(sub, "-o,--output", o.output,
       "file to write (default: standard output); robots and blocks of a world are written beside "
       "it");
}

namespace {

void frame_of_mesh(CLI::App* sub, double& unit, std::string& up) {
  choice(sub, "--unit", unit, {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}},
         "what the file's numbers are in (default: mm)");
  choice<std::string, std::string>(
      sub, "--up", up,
      {{"x", "x"}, {"y", "y"}, {"z", "z"}, {"-x", "-x"}, {"-y", "-y"}, {"-z", "-z"}},
      "the file's axis that points up (default: z)");
}

}  // namespace

void add_voxelise(CLI::App& app, VoxeliseOptions& o) {
  CLI::App* sub =
      command(app, "voxelise", "turn a mesh into bricks",
              "  stigc explore rulesets/stepped-pyramid.yaml -o pyramid.stl\n"
              "  stigc voxelise pyramid.stl --side 1mm -o pyramid.vox\n"
              "  stigc voxelise pyramid.stl --bricks 60 --up z -o fine.vox -o fine.png\n"
              "  stigc voxelise pyramid.stl --bricks 200 --shell -o hull.txt --json\n");
  file(sub, "MODEL", o.model, "a mesh (.stl .obj .off .ply)");
  integer(sub, "--bricks", o.mesh.bricks, 1, 1'000'000, "about so many bricks (default: 100)");
  parsed(sub, "--side", "LENGTH",
         "side of a brick in mm, or as 5.5cm, 0.055m, 2in; in place of --bricks",
         [&o](const std::string& text) { return parse_length(text, o.mesh.side); })
      ->excludes("--bricks");
  frame_of_mesh(sub, o.mesh.unit, o.mesh.up);
  CLI::Option* solid = sub->add_flag_callback(
      "--solid", [&o] { o.mesh.shell = false; }, "bricks whose middle is in the model (default)");
  sub->add_flag("--shell", o.mesh.shell, "bricks that the model's surface passes through")
      ->excludes(solid);
  repeated(sub, "-o,--output", o.outputs, "FILE",
           "structure to write, in the format of its ending; may be repeated")
      ->required();
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_convex(CLI::App& app, ConvexOptions& o) {
  CLI::App* sub =
      command(app, "convex", "turn a mesh into a solid for robots and scenes",
              "  stigc explore rulesets/stepped-pyramid.yaml -o pyramid.stl\n"
              "  stigc convex pyramid.stl --unit cm -o pyramid.yaml && stigc check pyramid.yaml\n"
              "  stigc convex pyramid.stl --parts 1 --up z -o hull.yaml --json\n");
  file(sub, "MODEL", o.model, "a mesh (.stl .obj .off .ply)");
  integer(sub, "--parts", o.parts, 1, 64,
          "convex pieces at most, fewer where they fit; 1: the hull (default: 16)");
  frame_of_mesh(sub, o.unit, o.up);
  path(sub, "-o,--output", o.output, "file of a solid to write, for `solid:`")->required();
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_measure(CLI::App& app, MeasureOptions& o) {
  CLI::App* sub = command(
      app, "measure", "measure a structure file",
      "  stigc explore rulesets/staircase.yaml -o staircase.vox && stigc measure staircase.vox\n"
      "  stigc explore rulesets/tiling.yaml -o tiling.vox\n"
      "  stigc measure tiling.vox --lattice hexagonal --json\n");
  file(sub, "STRUCTURE", o.structure, "structure file (.vox .json .txt), or a mesh");
  lattice(sub, o.lattice);
  mesh_bricks(sub, o.mesh);
  sub->add_flag("--json", o.json, "print one JSON object");
}

void add_draw(CLI::App& app, DrawOptions& o) {
  CLI::App* sub = command(app, "draw", "draw a structure file, or turn it into another format",
                          "  stigc explore rulesets/staircase.yaml -o staircase.vox\n"
                          "  stigc draw staircase.vox -o staircase.png\n"
                          "  stigc draw staircase.vox -o staircase.glb -o staircase.stl\n");
  file(sub, "STRUCTURE", o.structure, "structure file (.vox .json .txt), or a mesh");
  lattice(sub, o.lattice);
  mesh_bricks(sub, o.mesh);
  repeated(sub, "-o,--output", o.outputs, "FILE",
           "file to write, in the format of its ending; may be repeated")
      ->required();
  palette(sub, o.palette);
}

}  // namespace stig::cli
