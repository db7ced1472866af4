// SPDX-License-Identifier: MIT
// What the commands hand over to other programs: files, JSON, completion scripts.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "program.h"

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
  CHECK(place.file("s.txt") == "1 2 3\n");
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
  CHECK(completed("stigc completions f", 2) == "fish\n");
  CHECK(completed("stigc check se", 2) == "sets\n");
}

TEST_CASE("doctor has a line a finding, each with its health") {
  const Workplace place;
  const Outcome outcome = place.shell("stigc doctor sets/line.yaml");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.starts_with("ok    program    stigc "));
  CHECK(outcome.out.find("ok    rule sets  1 checked, all good\n") != std::string::npos);
  CHECK(place.shell("stigc doctor sets/bad.yaml").exit_code == 1);
  CHECK(place.shell("TMPDIR=/nonexistent stigc doctor sets/line.yaml").exit_code == 1);
  CHECK(parsed(place.shell("stigc doctor --json sets/line.yaml"))["ok"] == true);
}

TEST_CASE("colours: never into a file, unless asked for") {
  const Workplace place;
  CHECK(place.shell("stigc explore sets/line.yaml").out.find('\x1b') == std::string::npos);
  CHECK(place.shell("stigc explore --color always sets/line.yaml").out.find('\x1b') !=
        std::string::npos);
}

}  // namespace
}  // namespace stig
