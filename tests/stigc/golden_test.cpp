// SPDX-License-Identifier: MIT
// Every printed form, byte by byte. STIG_UPDATE_GOLDEN=1 writes the files anew.
#include <doctest/doctest.h>

#include <set>
#include <sstream>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

/// First words of the lines under "Commands:".
std::set<std::string> commands_of(const std::string& help) {
  std::set<std::string> out;
  std::istringstream lines(help.substr(help.find("Commands:\n") + 10));
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    if (line.size() > 2 && line[2] != ' ') out.insert(line.substr(2, line.find(' ', 2) - 2));
  }
  return out;
}

TEST_CASE("help of the program and of every command") {
  const Workplace place;
  hold(place, "help", "stigc --help");
  std::set<std::string> commands;
  for (const char* command :
       {"check",    "fmt",    "explore",     "explain", "test",  "verify",   "certify",  "graph",
        "replay",   "schema", "measure",     "draw",    "synth", "simulate", "describe", "compile",
        "validate", "build",  "completions", "doctor",  "view",  "render",   "voxelise", "search",
        "archive",  "sweep",  "merge",       "import",  "init",  "convex"}) {
    hold(place, std::string("help-") + command, std::string("stigc ") + command + " --help");
    commands.insert(command);
  }
  CHECK(commands == commands_of(place.stigc({"--help"}).out));
}

TEST_CASE("check prints problems for people and as JSON") {
  const Workplace place;
  hold(place, "check-good", "stigc check sets/corner.yaml sets/line.yaml");
  hold(place, "check-bad", "stigc check sets/bad.yaml sets/line.yaml");
  hold(place, "check-bad-json", "stigc check --diagnostics json sets/bad.yaml");
  hold(place, "check-color", "stigc check --color always sets/bad.yaml");
  hold(place, "check-missing", "stigc check missing.yaml");
}

TEST_CASE("describe lists a robot's parts") {
  const Workplace place;
  place.write("bebot.yaml", project_file("robots/bebot.yaml"));
  place.write("cart.yaml", project_file("robots/gripper_cart.yaml"));
  place.write("bad.yaml", project_file("tests/bad_robots/P609-axis-twice.yaml"));
  hold(place, "describe", "stigc describe bebot.yaml");
  hold(place, "describe-cart", "stigc describe cart.yaml");
  hold(place, "describe-json", "stigc describe cart.yaml --json");
  hold(place, "describe-bad", "stigc describe bad.yaml; stigc check cart.yaml bad.yaml");
}

TEST_CASE("compile prints decisions, or why there are none") {
  const Workplace place;
  place.write("staircase.yaml", project_file("rulesets/staircase.yaml"));
  place.write("exact.yaml", project_file("rulesets/staircase-exact.yaml"));
  place.write("high.yaml", project_file("tests/compiler/refused/P705-too-high.yaml"));
  place.write("stuck.yaml", project_file("tests/compiler/refused/P711-deadlock.yaml"));
  place.write("cart.yaml", project_file("robots/gripper_cart.yaml"));
  place.write("lock.yaml", project_file("tests/compiler/refused/P713-lock.yaml"));
  place.write("walled.yaml", project_file("tests/compiler/conflicts/walled.yaml"));
  hold(place, "compile", "stigc compile staircase.yaml");
  hold(place, "compile-dot", "stigc compile staircase.yaml --target dot");
  hold(place, "compile-ir", "stigc compile staircase.yaml --target ir");
  hold(place, "compile-refused",
       "stigc compile exact.yaml; stigc compile high.yaml; stigc compile stuck.yaml");
  hold(place, "compile-robots",
       "stigc compile lock.yaml; stigc compile lock.yaml --robots 1 --target ir; stigc compile "
       "walled.yaml");
  hold(place, "compile-cart", "stigc compile staircase.yaml --robot cart.yaml");
  hold(place, "compile-usage", "stigc compile staircase.yaml --sides up");
}

TEST_CASE("explore prints a summary or one object") {
  const Workplace place;
  hold(place, "explore", "stigc explore sets/line.yaml");
  hold(place, "explore-json", "stigc explore sets/line.yaml --json");
  hold(place, "explore-hexagonal", "stigc explore sets/sheet.yaml --box 4,4,1 --agents 2");
  hold(place, "explore-limit", "stigc explore sets/sheet.yaml --motion event --deposits 50");
  hold(place, "explore-runs", "stigc explore sets/corner.yaml --motion event --runs 40");
  hold(place, "explore-runs-json", "stigc explore sets/corner.yaml --motion event --runs 2 --json");
}

TEST_CASE("explain goes rule by rule") {
  const Workplace place;
  hold(place, "explain", "stigc explain sets/corner.yaml --at 1,0,0");
  hold(place, "explain-fires", "stigc explain sets/corner.yaml --at 0,0,1");
  hold(place, "explain-taken", "stigc explain sets/corner.yaml --at 0,0,0");
  hold(place, "explain-stage", "stigc explain sets/line.yaml --at 1,0,0 --stage 2");
  hold(place, "explain-json", "stigc explain sets/corner.yaml --at 1,0,0 --json");
  place.write("half.txt", "t .\n---\nt s\n");
  hold(place, "explain-structure",
       "stigc explain sets/corner.yaml --structure half.txt --at 0,1,0 --rule 2");
}

TEST_CASE("test says how each expectation stands and by what method") {
  const Workplace place;
  hold(place, "test-good", "stigc test sets/corner.yaml sets/line.yaml sets/sheet.yaml");
  hold(place, "test-wrong", "stigc test sets/wrong_expectation.yaml");
  hold(place, "test-budget", "stigc test --states 2 --samples 3 sets/line.yaml");
  hold(place, "test-json", "stigc test --json sets/line.yaml sets/wrong_expectation.yaml");
}

TEST_CASE("verify proves, refutes, or shows growth without end") {
  const Workplace place;
  hold(place, "verify-proved",
       "stigc verify sets/line.yaml --certificate line.cert --witness line");
  hold(place, "verify-refuted", "stigc verify sets/corner.yaml --witness corner");
  hold(place, "verify-endless", "stigc verify sets/sheet.yaml --witness sheet");
  hold(place, "verify-unknown", "stigc verify sets/sheet.yaml --box 9,9,1 --budget 0.000001");
  hold(place, "verify-json", "stigc verify sets/line.yaml --json");
  hold(place, "verify-refuted-json", "stigc verify sets/corner.yaml --json");
  place.write("pyramid.yaml", project_file("rulesets/stepped-pyramid.yaml"));
  hold(place, "verify-never-fires", "stigc check sets/slice.yaml; stigc verify sets/slice.yaml");
  place.write("exact.yaml", project_file("rulesets/staircase-exact.yaml"));
  hold(place, "verify-losses",
       "stigc verify pyramid.yaml --losses; stigc verify exact.yaml --losses; "
       "stigc verify pyramid.yaml --losses --states 100; stigc verify sets/corner.yaml --losses");
  hold(place, "verify-losses-json", "stigc verify exact.yaml --losses --json");
  hold(place, "verify-effort", "stigc verify pyramid.yaml --effort 0.00005");
  hold(place, "verify-replay",
       "stigc verify -q sets/corner.yaml --witness c > /dev/null; stigc replay c-first.stigt; "
       "stigc replay c-second.stigt");
}

TEST_CASE("certify accepts, or says what does not hold") {
  const Workplace place;
  hold(place, "certify", "stigc certify sets/line.yaml sets/line.cert");
  hold(place, "certify-json", "stigc certify sets/line.yaml sets/line.cert --json");
  hold(place, "certify-box", "stigc certify sets/line.yaml sets/line.cert --box 5,5,5");
  place.write("wrong.cert", "stigc-certificate 1\nrules 0\n");
  hold(place, "certify-malformed", "stigc certify sets/line.yaml wrong.cert");
  std::string missing = place.file("sets/line.cert");
  const std::size_t brick = missing.find("stage 2");
  missing.replace(brick, std::string::npos, "stage 2 order 0\nend 2\n");
  place.write("missing.cert", missing);
  hold(place, "certify-refused", "stigc certify sets/line.yaml missing.cert");
  hold(place, "certify-refused-json", "stigc certify sets/line.yaml missing.cert --json");
  place.write("bebot.yaml", project_file("robots/bebot.yaml"));
  place.write("stigmergic.yaml", project_file("blocks/stigmergic.yaml"));
  place.write("stairs.yaml", project_file("rulesets/staircase.yaml"));
  place.shell("stigc compile stairs.yaml --certificate work.cert -o stairs.txt");
  hold(place, "certify-work", "stigc certify stairs.yaml work.cert");
  hold(place, "certify-work-json", "stigc certify stairs.yaml work.cert --json --robot bebot.yaml");
  place.shell("sed 's/^put 1 0 0 2/put 1 0 0 3/' work.cert > changed.cert");
  hold(place, "certify-work-refused",
       "cat work.cert; stigc certify stairs.yaml changed.cert --block stigmergic.yaml; "
       "stigc certify stairs.yaml work.cert --sides=+x; "
       "sed 's/sides: .*/sides: [-y]/' stairs.yaml > turned.yaml; "
       "stigc certify turned.yaml work.cert; "
       "printf '\\357\\273\\277' | cat - work.cert > marked.cert; "
       "stigc certify stairs.yaml marked.cert; "
       "stigc certify stairs.yaml work.cert --box none");
  place.write("square.cnf", "p cnf 2 4\n1 2 0\n1 -2 0\n-1 2 0\n-1 -2 0\n");
  place.write("square.drat", "1 0\n0\n");
  place.write("empty.drat", "");
  hold(place, "certify-drat", "stigc certify --drat square.cnf square.drat");
  hold(place, "certify-drat-json", "stigc certify --drat square.cnf square.drat --json");
  hold(place, "certify-drat-refused", "stigc certify --drat square.cnf empty.drat");
}

TEST_CASE("graph, fmt, replay, measure") {
  const Workplace place;
  hold(place, "graph", "stigc graph sets/corner.yaml");
  hold(place, "graph-stages", "stigc graph sets/line.yaml");
  hold(place, "fmt", "stigc fmt sets/corner.yaml");
  hold(place, "replay", "stigc explore sets/line.yaml --trace t.stigt && stigc replay t.stigt");
  hold(place, "replay-json", "stigc replay t.stigt --json");
  place.write("half.txt", "1 .\n---\n1 2\n");
  hold(place, "measure", "stigc measure half.txt");
  hold(place, "measure-json", "stigc measure half.txt --json");
}

TEST_CASE("synth prints a rule set, a summary, or why there is none") {
  const Workplace place;
  place.write("stairs.txt", "3 . .\n---\n3 2 .\n---\n3 2 1\n");
  hold(place, "synth", "stigc synth stairs.txt --colours given --floor");
  hold(place, "synth-summary", "stigc synth stairs.txt -o s.yaml && stigc check s.yaml");
  hold(place, "synth-test", "stigc test s.yaml");
  place.write("apart.txt", "1 . 1\n");
  hold(place, "synth-impossible",
       "stigc synth apart.txt; stigc synth apart.txt --json | grep -v seconds");
  hold(place, "synth-not-found",
       "stigc synth stairs.txt --colours 1 --order raster --start 0,0,0; "
       "stigc synth stairs.txt --colours 1 --order raster --start 0,0,0 --json | grep -v seconds");
  hold(place, "synth-asymmetric", "stigc synth stairs.txt --symmetry rotations --start 0,0,0");
}

TEST_CASE("synth for a robot prints rules that compile, or what keeps the robot from building") {
  const Workplace place;
  place.write("bebot.yaml", project_file("robots/bebot.yaml"));
  place.write("wall.txt", "1 1 1 1\n---\n1 1 1 1\n");
  place.write("mound.txt", ". . .\n. 1 .\n. . .\n---\n1 1 1\n1 1 1\n1 1 1\n");
  place.write("apart.txt", "1 . 1 1\n");
  place.write("one.txt", "1\n");
  place.write("plate.txt", "1 1 1 1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n");
  hold(place, "synth-robot",
       "stigc synth wall.txt --robot bebot.yaml --robots 2 -o wall.yaml --certificate wall.cert && "
       "stigc certify wall.yaml wall.cert && stigc compile -W error wall.yaml");
  hold(place, "synth-robot-rules",
       "stigc synth wall.txt --robot bebot.yaml --sides=+y --start 1,0,0 --colours 3");
  hold(place, "synth-robot-json",
       "stigc synth wall.txt --robot bebot.yaml --json | grep -v seconds");
  hold(place, "synth-robot-impossible",
       "stigc synth mound.txt --robot bebot.yaml; stigc synth apart.txt --robot bebot.yaml; "
       "stigc synth mound.txt --robot bebot.yaml --sides=+x --json | grep -v seconds; "
       "stigc synth wall.txt --robot bebot.yaml --colours 1; "
       "stigc synth wall.txt --robot bebot.yaml --colours 1 --json | grep -v seconds");
  hold(place, "synth-robot-usage",
       "stigc synth wall.txt --sides=+x; stigc synth wall.txt --block block.yaml; stigc synth "
       "wall.txt --robot bebot.yaml --symmetry "
       "rotations; stigc synth wall.txt --robot bebot.yaml --colours 5; stigc synth wall.txt "
       "--robot bebot.yaml --start 0,0,1; stigc synth one.txt --robot bebot.yaml; stigc synth "
       "wall.txt --robot none.yaml; stigc synth plate.txt --robot bebot.yaml --colours 1 "
       "--effort 1 --sides=+x");
}

TEST_CASE("usage errors name what is wrong and what was meant") {
  const Workplace place;
  hold(place, "usage",
       "{ for words in '' 'chek' 'explore' 'explore sets/line.yaml --boxx 1,1,1' "
       "'explore sets/line.yaml --motion wlak' 'explore sets/line.yaml --agents -3' "
       "'explore sets/line.yaml --agents 99999999999999999999' "
       "'explore sets/line.yaml --agents 1e3' 'explore sets/line.yaml --box 1,2' "
       "'explore sets/line.yaml --box 0,1,1' 'explore sets/line.yaml --box 100000,100000,1000' "
       "'explore sets/line.yaml --seed -1' 'explore sets/line.yaml --seed 1 --seed 2' "
       "'explore sets/line.yaml --moves 7' 'explore sets/line.yaml -o x.foo' "
       "'explore sets/line.yaml -o x.png --runs 2' 'explore sets/line.yaml --trace t --runs 2' "
       "'explore sets/line.yaml --motion event --agents 3' 'explore sets/line.yaml --box none' "
       "'explain sets/line.yaml' 'explain sets/line.yaml --at 0,0,0 --stage 3' "
       "'explain sets/line.yaml --at 0,0,0 --rule 3' 'draw sets/line.yaml -o x.foo' "
       "'fmt sets/line.yaml sets/corner.yaml' 'completions tcsh' '--diagnostics xml check a'; do "
       "echo \"stigc $words\"; stigc $words; echo \"  exit $?\"; done; } 2>&1");
}

}  // namespace
}  // namespace stig
