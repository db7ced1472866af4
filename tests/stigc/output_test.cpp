// SPDX-License-Identifier: MIT
// What the commands hand over to other programs: files, JSON, completion scripts.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

using nlohmann::json;

json parsed(const Outcome& outcome) {
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return json::parse(outcome.out);
}

TEST_CASE("explore writes every format by its ending, several at once") {
  const Workplace place;
  const Outcome outcome = place.shell(
      "stigc explore sets/line.yaml -o s.vox -o s.stl -o s.ply -o s.glb -o s.png -o s.svg "
      "-o s.json -o s.txt -o s.csv -o s.stigt --trace trace");
  REQUIRE(outcome.exit_code == 0);
  CHECK(place.files().size() == 11);
  CHECK(place.file("s.vox").starts_with("VOX "));
  CHECK(place.file("s.ply").starts_with("ply\n"));
  CHECK(place.file("s.glb").starts_with("glTF"));
  CHECK(place.file("s.png").starts_with("\x89PNG"));
  CHECK(place.file("s.txt") ==
        "// lattice: cubic\n// lowest corner: 0 0 0\n// bricks: 1 2 3\n1 2 3\n");
  CHECK(place.file("s.stigt").starts_with("stigtrc1"));
  CHECK(place.file("s.stigt") == place.file("trace"));
  CHECK(place.file("s.csv").starts_with("deposit,step,x,y,z,brick,rule,orientation,agent\n1,"));
  const json structure = json::parse(place.file("s.json"));
  CHECK(structure["cells"].size() == 3);
}

TEST_CASE("the limit of the last stage is not told as one that nobody asked for") {
  const Workplace place;
  const Outcome outcome = place.shell(
      "sed 's/^symmetry/stages: {1: 4}\\nsymmetry/; s/    place: 1/&\\n    stage: 1/; "
      "/^expect/,$d' "
      "sets/sheet.yaml > staged.yaml; stigc explore staged.yaml --motion event --json");
  const json run = parsed(outcome);
  CHECK(run["terminated"] == "deposits");
  CHECK(run["deposits"] == 4);
  CHECK(outcome.err.find("--deposits") == std::string::npos);
}

TEST_CASE("structure files go round: written by one command, read by the next") {
  const Workplace place;
  REQUIRE(place.shell("stigc explore sets/line.yaml -q -o a.vox -o a.json").exit_code == 0);
  REQUIRE(place.shell("stigc draw a.vox -o b.json && stigc draw a.json -o c.vox").exit_code == 0);
  CHECK(parsed(place.stigc({"measure", "b.json", "--json"}))["structure_hash"] ==
        parsed(place.stigc({"measure", "a.json", "--json"}))["structure_hash"]);
  const json said = parsed(place.stigc(
      {"explain", "sets/line.yaml", "--structure", "c.vox", "--at", "3,0,0", "--json"}));
  CHECK(said["rules"][0]["fires"] == false);
}

TEST_CASE("text files keep lattice, place and symbols") {
  const Workplace place;
  REQUIRE(place
              .shell("stigc explore sets/sheet.yaml -q --motion event --deposits 30 "
                     "-o a.txt -o a.json -o a.vox")
              .exit_code == 0);
  json text = parsed(place.stigc({"measure", "a.txt", "--json"}));
  json object = parsed(place.stigc({"measure", "a.json", "--json"}));
  json vox = parsed(place.stigc({"measure", "a.vox", "--lattice", "hexagonal", "--json"}));
  CHECK(parsed(place.stigc({"measure", "a.vox", "--json"}))["lattice"] == "cubic");
  CHECK(text["lattice"] == "hexagonal");
  for (json* one : {&text, &object, &vox}) one->erase("structure");
  CHECK(text == object);
  CHECK(vox["measures"] == object["measures"]);
  CHECK(place.stigc({"measure", "a.txt", "--lattice", "cubic"}).exit_code == 1);
  CHECK(place.stigc({"measure", "a.json", "--lattice", "cubic"}).exit_code == 1);
  CHECK(place.stigc({"explain", "sets/line.yaml", "--structure", "a.txt", "--at", "0,0,0"})
            .exit_code == 1);
}

TEST_CASE("explain takes the place from the file, and says so when there is none") {
  const Workplace place;
  REQUIRE(place.shell("stigc explore sets/corner.yaml -q -o a.txt -o a.vox").exit_code == 0);
  for (const char* file : {"a.txt", "a.vox"}) {
    const Outcome kept =
        place.stigc({"explain", "sets/corner.yaml", "--structure", file, "--at", "1,0,0"});
    CHECK(kept.exit_code == 0);
    CHECK(kept.err.empty());
  }
  place.write("bare.txt", "t .\n---\nt s\n");
  const Outcome bare =
      place.stigc({"explain", "sets/corner.yaml", "--structure", "bare.txt", "--at", "1,0,0"});
  CHECK(bare.exit_code == 0);
  CHECK(bare.err.find("(0, 0, 0)") != std::string::npos);
  CHECK(place.stigc({"measure", "bare.txt"}).exit_code == 0);
  CHECK(place.stigc({"draw", "bare.txt", "-o", "bare.png"}).exit_code == 0);
}

TEST_CASE("draw takes an output once") {
  const Workplace place;
  place.write("s.txt", "1 2\n");
  const Outcome outcome = place.stigc({"draw", "s.txt", "-o", "t.json", "-o", "t.json"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err == "stigc: 't.json' is given twice\n");
  CHECK(place.files() == std::vector<std::string>{"s.txt"});
}

TEST_CASE("test counts files that expect nothing apart") {
  const Workplace place;
  REQUIRE(place.shell("sed '/^expect/,$d' sets/line.yaml > bare.yaml").exit_code == 0);
  const Outcome alone = place.shell("stigc test bare.yaml");
  CHECK(alone.exit_code == 0);
  CHECK(alone.out == "bare.yaml\n  nothing is expected\n1 file expects nothing\n");
  CHECK(place.shell("stigc test bare.yaml sets/line.yaml")
            .out.ends_with("1 of 1 file is as expected, 1 file expects nothing\n"));
  const json all = parsed(place.shell("stigc test --json bare.yaml sets/line.yaml"));
  CHECK(all["passed"] == 1);
  CHECK(all["of"] == 1);
  CHECK(all["without_expectations"] == 1);
  CHECK(all["files"][0]["expectations"] == 0);
  CHECK(all["files"][1]["expectations"] == 3);
}

TEST_CASE("the object of explore --json has every field promised") {
  const Workplace place;
  const json run = parsed(place.shell("stigc explore sets/corner.yaml --json --seed 5"));
  for (const char* key :
       {"ruleset", "ruleset_hash", "seed", "box", "motion", "agents", "steps", "deposits", "bricks",
        "terminated", "structure_hash", "colours", "rules", "measures"}) {
    CHECK_MESSAGE(run.contains(key), key);
  }
  CHECK(run["seed"] == 5);
  CHECK(run["bricks"] == run["deposits"].get<int>() + 1);
  CHECK(run["colours"]["t"].get<int>() + run["colours"]["s"].get<int>() == run["bricks"]);
  CHECK(run["terminated"] == "saturated");
}

TEST_CASE("runs: an array of the same objects, and the number of distinct structures") {
  const Workplace place;
  const json all =
      parsed(place.shell("stigc explore sets/corner.yaml --motion event --json --runs 30"));
  REQUIRE(all["runs"].size() == 30);
  std::set<std::string> hashes;
  for (const json& run : all["runs"]) {
    CHECK(run.contains("measures"));
    hashes.insert(run["structure_hash"].get<std::string>());
  }
  CHECK(all["distinct_structures"] == hashes.size());
  CHECK(all["runs"][0] ==
        parsed(place.shell("stigc explore sets/corner.yaml --motion event --json")));
}

TEST_CASE("the same bytes for the same seed, whatever the number of threads") {
  const Workplace place;
  const std::string command = "stigc explore sets/corner.yaml -q --json --runs 70 --seed 3 ";
  const Outcome one = place.shell(command + "--threads 1 -o one.csv");
  const Outcome four = place.shell(command + "--threads 4 -o four.csv");
  CHECK(one.exit_code == 0);
  CHECK(one.out == four.out);
  CHECK(place.file("one.csv") == place.file("four.csv"));
  CHECK(place.shell("stigc explore sets/corner.yaml -q --json --runs 70 --seed 4").out != one.out);
}

TEST_CASE("with runs, {run} in a name numbers the files") {
  const Workplace place;
  REQUIRE(place.shell("stigc explore sets/line.yaml --runs 2 -o 's{run}.txt'").exit_code == 0);
  CHECK(place.files() == std::vector<std::string>{"s0.txt", "s1.txt"});
  // One run has the number 0; the table of runs has none, and every one that is named is written.
  REQUIRE(place.shell("stigc explore sets/line.yaml -o 'd{run}.csv' --trace 't{run}.stigt'")
              .exit_code == 0);
  CHECK(place.has("d0.csv"));
  CHECK(place.has("t0.stigt"));
  REQUIRE(place.shell("stigc explore sets/line.yaml --runs 2 -o a.csv -o b.csv").exit_code == 0);
  CHECK(place.file("a.csv") == place.file("b.csv"));
  const Outcome numbered = place.shell("stigc explore sets/line.yaml --runs 2 -o 'x{run}.csv'");
  CHECK(numbered.exit_code == 2);
  CHECK(numbered.err ==
        "stigc: 'x{run}.csv': with --runs .csv is one table of all runs: leave {run} out\n");
}

TEST_CASE("the box stands where --origin says, and JSON calls it so") {
  const Workplace place;
  const auto box_of = [&](const std::string& line) { return parsed(place.shell(line))["box"]; };
  const std::string explore = "stigc explore sets/corner.yaml --json ";
  CHECK(box_of(explore + "--box 5,5,5 --origin -1,-2,0") ==
        json::parse(R"({"origin": [-1, -2, 0], "size": [5, 5, 5], "periodic": false})"));
  CHECK(box_of(explore + "--origin=-9,-8,-7")["size"] == json::parse("[20, 20, 20]"));
  CHECK(box_of(explore + "--motion event --origin=-9,-8,-7")["origin"] ==
        json::parse("[-9, -8, -7]"));
  // The file's box is moved, and keeps its size and its sides.
  REQUIRE(place
              .shell("sed '/^expect/,$d' sets/line.yaml > boxed.yaml; echo 'box: {size: [9, 8, 7], "
                     "origin: [0, 0, 0], periodic: true}' >> boxed.yaml")
              .exit_code == 0);
  CHECK(box_of("stigc explore boxed.yaml --json --origin=-1,-1,-1") ==
        json::parse(R"({"origin": [-1, -1, -1], "size": [9, 8, 7], "periodic": true})"));
  const json sheet = parsed(place.shell(
      "stigc explore sets/sheet.yaml --motion event --box 3,2,1 --origin -2,0,0 --json"));
  CHECK(sheet["measures"]["bounds"]["low"] == json::parse("[-2, 0, 0]"));
  CHECK(sheet["measures"]["bounds"]["high"] == json::parse("[0, 1, 0]"));
}

TEST_CASE("verify and certify mean the box that --origin moves") {
  const Workplace place;
  const std::string box = " --box 5,5,5 --origin ";
  const std::string at = box + "-1,-2,-2 ";
  const json proof = parsed(place.shell("stigc verify sets/line.yaml --certificate c --json" + at));
  CHECK(proof["box"]["origin"] == json::parse("[-1, -2, -2]"));
  const json check = parsed(place.shell("stigc certify sets/line.yaml c --json" + at));
  CHECK(check["box"] == proof["box"]);
  CHECK(place.shell("stigc certify sets/line.yaml c" + box + "-2,-2,-2").exit_code == 1);
}

TEST_CASE("an origin without a box, or away from the start, is a usage error") {
  const Workplace place;
  for (const std::string line :
       {"explore sets/line.yaml --box none --motion event --origin 0,0,0",
        "explore sets/line.yaml --box 3,3,3 --origin 9,9,9", "explore sets/line.yaml --origin 1,2",
        "verify sets/line.yaml --origin 0,0,0", "verify sets/line.yaml --box none --origin 0,0,0",
        "verify sets/line.yaml --box 3,3,3 --origin 9,9,9",
        "certify sets/line.yaml sets/line.cert --origin 0,0,0",
        "certify sets/line.yaml sets/line.cert --periodic", "certify --drat a b --origin 0,0,0",
        "certify --fewest a --origin 0,0,0"}) {
    CAPTURE(line);
    CHECK(place.shell("stigc " + line).exit_code == 2);
  }
}

TEST_CASE("only a certificate of robots' work has to do with a robot") {
  const Workplace place;
  for (const std::string line :
       {"--drat a b --robot bebot.yaml", "--fewest a --block stigmergic.yaml",
        "sets/line.yaml sets/line.cert --robot bebot.yaml"}) {
    CAPTURE(line);
    CHECK(place.shell("stigc certify " + line).exit_code == 2);
  }
}

TEST_CASE("agents start where they are told") {
  const Workplace place;
  const std::string command = "stigc explore sets/line.yaml --json --steps 1 --agents ";
  CHECK(parsed(place.shell(command + "1 --agents-at 1,0,0"))["deposits"] == 1);
  CHECK(parsed(place.shell(command + "2 --agents-at '5,5,5;-3,0,0'"))["deposits"] == 0);
  CHECK(parsed(place.shell(command + "2 --agents-at 1,0,0 --agents-at -3,0,0"))["deposits"] == 1);
}

TEST_CASE("fmt --write makes fmt --check content, and keeps the meaning") {
  const Workplace place;
  place.write("set.yaml", place.file("sets/corner.yaml"));
  CHECK(place.shell("stigc fmt --check set.yaml").exit_code == 1);
  CHECK(place.shell("stigc fmt --write set.yaml").exit_code == 0);
  CHECK(place.shell("stigc fmt --check set.yaml").exit_code == 0);
  CHECK(parsed(place.shell("stigc explore set.yaml --json"))["ruleset_hash"] ==
        parsed(place.shell("stigc explore sets/corner.yaml --json"))["ruleset_hash"]);
}

TEST_CASE("a trace that was tampered with does not replay") {
  const Workplace place;
  REQUIRE(place.shell("stigc explore sets/line.yaml --trace t.stigt").exit_code == 0);
  std::string bytes = place.file("t.stigt");
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  place.write("t.stigt", bytes);
  CHECK(place.shell("stigc replay t.stigt").exit_code == 1);
}

TEST_CASE("completion scripts parse in their shells") {
  const Workplace place;
  for (const char* shell : {"bash", "zsh", "fish"}) {
    CAPTURE(shell);
    const std::string name = shell;
    REQUIRE(place.shell("stigc completions " + name + " > script").exit_code == 0);
    const std::string none = name == "fish" ? "--no-execute" : "-n";
    CHECK(
        place
            .shell("command -v " + name + " >/dev/null || exit 0; " + name + " " + none + " script")
            .exit_code == 0);
    CHECK(place.file("script").find("walk teleport event") != std::string::npos);
  }
}

TEST_CASE("bash completes commands, options, words and files") {
  const Workplace place;
  const auto completed = [&](const std::string& words, int at) {
    const Outcome outcome =
        place.shell("eval \"$(stigc completions bash)\"; compopt() { :; }; COMP_WORDS=(" + words +
                    "); COMP_CWORD=" + std::to_string(at) + "; _stigc; echo ${COMPREPLY[@]}");
    return outcome.out;
  };
  CHECK(completed("stigc expl", 1) == "explore explain\n");
  CHECK(completed("stigc explore --mot", 2) == "--motion\n");
  CHECK(completed("stigc explore --motion te", 3) == "teleport\n");
  for (const std::string command : {"explore", "verify", "certify"}) {
    CHECK(completed("stigc " + command + " --orig", 2) == "--origin\n");
  }
  CHECK(completed("stigc completions f", 2) == "fish\n");
  CHECK(completed("stigc check se", 2) == "sets\n");
  CHECK(completed("stigc --explain P70", 2).starts_with("P701 P702 "));
  CHECK(completed("stigc check --explain R304", 3) == "R304\n");
}

TEST_CASE("compile writes all that an ARGoS experiment needs, or nothing") {
  const Workplace place;
  place.write("s.yaml", project_file("rulesets/staircase.yaml"));
  const std::vector<std::string> all = {"e.argos", "e_block.lua", "e_robot.lua", "e_robot.lua.map",
                                        "s.yaml"};
  CHECK(place.stigc({"compile", "s.yaml", "--target", "argos", "-o", "e"}).exit_code == 0);
  CHECK(place.files() == all);
  const std::string first = place.file("e.argos") + place.file("e_robot.lua");
  CHECK(place.stigc({"compile", "s.yaml", "-o", "e.argos"}).exit_code == 0);
  CHECK(place.files() == all);
  CHECK(place.file("e.argos") + place.file("e_robot.lua") == first);
  CHECK(place.file("e.argos").find("script=\"e_robot.lua\"") != std::string::npos);
  CHECK(place.file("e_block.lua") == project_file("programs/argos_block.lua"));
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"compile", "s.yaml", "--target", "argos"},
        {"compile", "s.yaml", "--target", "argos", "-o", "-"},
        {"compile", "s.yaml", "--target", "argos", "-o", ".argos"},
        {"compile", "s.yaml", "--target", "argos", "-o", "n\x01"},
        {"compile", "s.yaml", "--target", "argos", "-o", "n\xff"},
        {"compile", "s.yaml", "--robot", "r.yaml", "--target", "argos", "-o", "n"}}) {
    CAPTURE(wrong.back());
    CHECK(place.stigc(wrong).exit_code == 2);
  }
  CHECK(place.stigc({"compile", "s.yaml", "--target", "argos", "-o", "none/n"}).exit_code == 3);
  // A rule set that cannot be compiled leaves nothing either.
  CHECK(place.stigc({"compile", "sets/corner.yaml", "-o", "n.argos"}).exit_code == 1);
  CHECK(place.files() == all);
}

TEST_CASE("an experiment has as many robots as were asked for, the rules say, or one") {
  const Workplace place;
  std::string rules = project_file("rulesets/staircase.yaml");
  const std::string one = "  robots: 1\n";
  const std::size_t at = rules.find(one);
  REQUIRE(at != std::string::npos);
  place.write("two.yaml", std::string(rules).replace(at, one.size(), "  robots: 2\n"));
  place.write("any.yaml", rules.erase(at, one.size()));
  const auto robots = [&](const std::string& words) {
    const Outcome outcome = place.shell("stigc compile " + words + " -o e.argos");
    CHECK_MESSAGE(outcome.exit_code == 0, outcome.err);
    std::size_t count = 0;
    const std::string text = place.file("e.argos");
    for (std::size_t i = 0; (i = text.find("<builderbot id=", i)) != std::string::npos; ++i)
      ++count;
    const bool assumed = outcome.err.find("assumed: one robot") != std::string::npos;
    return std::to_string(count) + (assumed ? ", assumed" : "");
  };
  CHECK(robots("any.yaml") == "1, assumed");
  CHECK(robots("any.yaml --robots 1") == "1");
  CHECK(robots("two.yaml") == "2");
  CHECK(robots("two.yaml --robots 1") == "1");
  // A program by itself is one whatever the number.
  CHECK(place.shell("stigc compile any.yaml -o p.lua").err.find("assumed") == std::string::npos);
}

TEST_CASE("doctor has a line a finding, each with its health") {
  const Workplace place;
  const Outcome outcome = place.shell("stigc doctor sets/line.yaml");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.starts_with("ok    program    stigc "));
  CHECK(outcome.out.find("ok    rule sets  1 checked, all good\n") != std::string::npos);
  CHECK(outcome.out.find("ok    physics    DART 6.") != std::string::npos);
  // What came with this build: pages or what they take.
  const std::string pages = outcome.out.substr(outcome.out.find("ok    pages      "));
  CHECK(pages.substr(0, pages.find('\n')).find("viewer") != std::string::npos);
  CHECK(pages.substr(0, pages.find('\n')).find("playground") != std::string::npos);
  CHECK(place.shell("stigc doctor sets/bad.yaml").exit_code == 1);
  CHECK(place.shell("TMPDIR=/nonexistent stigc doctor sets/line.yaml").exit_code == 1);
  CHECK(parsed(place.shell("stigc doctor --json sets/line.yaml"))["ok"] == true);
  // Cores that the process may use, and not all that there are.
  const Outcome one = place.shell(
      "first=$(taskset -cp $$ | sed 's/.*: //; s/[,-].*//'); taskset -cp $first $$ > first.txt; "
      "stigc doctor");
  CHECK(one.out.find("processor  1 core,") != std::string::npos);
}

TEST_CASE("colours: never into a file, unless asked for") {
  const Workplace place;
  CHECK(place.shell("stigc explore sets/line.yaml").out.find('\x1b') == std::string::npos);
  CHECK(place.shell("stigc explore --color always sets/line.yaml").out.find('\x1b') !=
        std::string::npos);
}

}  // namespace
}  // namespace stig
