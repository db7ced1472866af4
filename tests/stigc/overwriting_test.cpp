// SPDX-License-Identifier: MIT
// No command writes over what it reads, or one output over another, and all say in the same way
// that an output cannot be written. A table of every command's every output.
#include <doctest/doctest.h>

#include "program.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

/// One output of a command. The shell has the input's name in $in and the output's in $out.
struct Case {
  std::string ending;  ///< of both names
  std::string input;   ///< bytes of the input
  std::string command;
};

std::vector<Case> all_cases(const Workplace& place) {
  const std::string rules = project_file("rulesets/staircase.yaml");
  const std::string bebot = project_file("robots/bebot.yaml");
  const std::string block = project_file("blocks/stigmergic.yaml");
  const std::string program = "function step() end\n";
  const std::string scene = "stigc_scene: 1\nduration: 0.01\n";
  REQUIRE(place
              .shell("stigc simulate sets/fall.yaml --duration 0.01 --trace t.stigp "
                     "--checkpoint c.stigk; echo 'a a' > target.txt; cp -L sets/line.yaml .; "
                     "stigc explore line.yaml -q --trace t.stigt")
              .exit_code == 0);
  place.write("staircase.yaml", rules);
  place.write("bebot.yaml", bebot);
  place.write("robot-with-program.yaml", bebot + "\nprogram: in.lua\n");
  place.write("block.yaml", block);
  place.write("user.lua", program);
  place.write("uses.yaml", scene + "robots: [{file: bebot.yaml, at: [0, 0], program: in.lua}]\n");
  REQUIRE(place.shell("sed 's/^program: .*/program: in.lua/' block.yaml > with-program.yaml")
              .exit_code == 0);
  return {
      {".txt", rules, "stigc explore $in -o $out"},
      {".csv", rules, "stigc explore $in -o $out"},
      {".csv", rules, "stigc explore $in --runs 2 -o $out"},
      {"-1.txt", rules, "stigc explore $in --runs 2 -o ${out%-1.txt}-{run}.txt"},
      {".any", rules, "stigc explore $in --trace $out"},
      {".any", rules, "stigc explore - --trace $out < $in"},
      {".any", rules, "stigc verify $in --certificate $out"},
      {".png", rules, "stigc verify $in --witness ${out%.png}"},
      {"-walled-in-1.stigt", rules, "stigc verify $in --witness ${out%-walled-in-1.stigt}"},
      {".txt", "a a\n", "stigc synth $in -o $out"},
      {".txt", "a a\n", "stigc synth $in --certificate $out"},
      {".yaml", scene, "stigc simulate $in --trace $out"},
      {".png", scene, "stigc simulate $in -o $out"},
      {".yaml", scene, "stigc simulate $in --checkpoint $out"},
      {".lua", program, "stigc simulate uses.yaml --trace $out"},
      {".png", place.file("c.stigk"), "stigc simulate --resume $in -o $out"},
      {".png", place.file("t.stigp"), "stigc replay $in -o $out"},
      {".png", place.file("t.stigp"), "stigc render $in -o $out"},
      {".glb", place.file("t.stigp"), "stigc render $in -o $out"},
      {".svg", place.file("t.stigt"), "stigc render $in -o $out"},
      {".png", bebot, "stigc describe $in -o $out"},
      {".glb", bebot, "stigc describe $in -o $out"},
      {".any", rules, "stigc compile $in -o $out"},
      {".any", rules, "stigc compile $in --report $out"},
      {".any", rules, "stigc compile $in --target lua -o $out"},
      {".lua.map", rules, "stigc compile $in -o ${out%.map}"},
      {".any", bebot, "stigc compile staircase.yaml --robot $in -o $out"},
      {".any", block, "stigc compile staircase.yaml --block $in -o $out"},
      {".any", block, "stigc synth target.txt --robot bebot.yaml --block $in -o $out"},
      {".any", bebot, "stigc synth target.txt --robot $in --certificate $out"},
      {".lua", program, "stigc compile staircase.yaml --block with-program.yaml -o $out"},
      {".lua", program, "stigc compile staircase.yaml --robot robot-with-program.yaml -o $out"},
      {".lua", program,
       "stigc synth target.txt --robot bebot.yaml --block with-program.yaml -o $out"},
      {".argos", rules, "stigc compile $in -o $out"},
      {"_robot.lua", rules, "stigc compile $in --target argos -o ${out%_robot.lua}"},
      {"_robot.lua.map", rules, "stigc compile $in --target argos -o ${out%_robot.lua.map}"},
      {"_block.lua", rules, "stigc compile $in --target argos -o ${out%_block.lua}"},
      {".txt", "a a\n", "stigc draw $in -o $out"},
  };
}

/// Puts the input and its other names there, and a copy to compare with.
void put_input(const Workplace& place, const Case& one) {
  place.write("in" + one.ending, one.input);
  REQUIRE(place
              .shell("cp in" + one.ending + " copy; ln -s in" + one.ending + " soft" + one.ending +
                     "; ln in" + one.ending + " hard" + one.ending + "; mkdir sub; ln -s .. sub/up")
              .exit_code == 0);
}

void take_away_input(const Workplace& place, const Case& one) {
  place.shell("rm -r copy sub {in,soft,hard}" + one.ending);
}

/// The command with these names for its input and its output.
Outcome run(const Workplace& place, const Case& one, const std::string& out) {
  return place.shell("in=in" + one.ending + "; out=" + out + one.ending + "; " + one.command);
}

}  // namespace

TEST_CASE("no command writes over what it reads, by whatever name") {
  const Workplace place;
  for (const Case& one : all_cases(place)) {
    CAPTURE(one.command);
    put_input(place, one);
    const std::vector<std::string> before = place.files();
    for (const char* out : {"in", "./in", "soft", "hard", "sub/up/in", "sub/../soft"}) {
      CAPTURE(out);
      const Outcome outcome = run(place, one, out);
      CHECK(outcome.exit_code == 2);
      CHECK(outcome.err.find("would be written over what is read\n") != std::string::npos);
      CHECK(place.shell("cmp in" + one.ending + " copy").exit_code == 0);
      CHECK(place.files() == before);
    }
    take_away_input(place, one);
  }
}

TEST_CASE("an output that cannot be written is a failure of the run, whatever the command") {
  const Workplace place;
  for (const Case& one : all_cases(place)) {
    CAPTURE(one.command);
    put_input(place, one);
    REQUIRE(place.shell("mkdir folder" + one.ending + "; ln -s none/there dangling" + one.ending)
                .exit_code == 0);
    const std::vector<std::string> before = place.files();
    for (const char* out : {"none/out", "copy/out", "folder", "dangling"}) {
      CAPTURE(out);
      const Outcome outcome = run(place, one, out);
      CHECK(outcome.exit_code == 3);
      CHECK(outcome.err.find("stigc: cannot write '") != std::string::npos);
      CHECK(place.files() == before);
    }
    place.shell("rm -r {folder,dangling}" + one.ending);
    take_away_input(place, one);
  }
}

TEST_CASE("no two outputs of a command are one file, standard output among them") {
  const Workplace place;
  all_cases(place);
  place.shell("mkdir sub; ln -s ../a.txt sub/a.txt; ln -s a.txt a.png");
  const std::vector<std::string> before = place.files();
  for (const std::string line :
       {"stigc explore line.yaml -o a.txt -o a.txt",
        "stigc explore line.yaml -o a.txt -o ./a.txt",
        "stigc explore line.yaml -o a.txt --trace sub/a.txt",
        "stigc explore line.yaml --runs 11 -o 'a{run}.txt' -o 'a{run}0.txt'",
        "stigc verify line.yaml --witness w --certificate w.png",
        "stigc synth target.txt -o a.txt --certificate sub/a.txt",
        "stigc synth target.txt -o proof/fewer.cnf --proof proof",
        "stigc synth target.txt -o a --proof a",
        "stigc synth target.txt -o ./a --proof sub/../a/",
        "stigc synth target.txt -o sub --proof sub",
        "stigc synth target.txt --certificate a --proof a",
        "stigc synth target.txt -o a --certificate a/b",
        "stigc explore line.yaml -o a.txt -o a.txt/b.txt",
        "stigc simulate sets/still.yaml --trace a.txt -o a.png",
        "stigc simulate sets/still.yaml --trace a --checkpoint ./a",
        "stigc compile staircase.yaml -o a.lua --report a.lua.map",
        "stigc compile staircase.yaml -o a.argos --report a_block.lua",
        "stigc compile staircase.yaml -o - --report -",
        "stigc compile staircase.yaml --report -",
        "stigc draw target.txt -o a.txt -o sub/a.txt"}) {
    CAPTURE(line);
    CHECK(place.shell(line).exit_code == 2);
    CHECK(place.files() == before);
  }
  CHECK(place.shell("stigc explore line.yaml -o out.txt > out.txt").exit_code == 2);
  CHECK(place.file("out.txt").empty());
}

TEST_CASE("folders: of a proof, and of a validation") {
  const Workplace place;
  place.write("x.txt", "a a\n");
  place.write("r.yaml", project_file("rulesets/staircase.yaml"));
  REQUIRE(place.shell("mkdir p d; ln x.txt p/fewer.cnf; ln r.yaml d/run-2.stigp").exit_code == 0);
  CHECK(place.shell("stigc synth x.txt --proof p/").exit_code == 2);
  CHECK(place.shell("stigc synth x.txt --proof none/p").exit_code == 3);
  CHECK(place.shell("stigc synth x.txt --proof x.txt").exit_code == 3);
  const std::string validate = "stigc validate r.yaml --duration 1 --runs 2 -o ";
  CHECK(place.shell(validate + "d").exit_code == 2);
  CHECK(place.shell(validate + "none/d").exit_code == 3);
  CHECK(place.shell(validate + "x.txt").exit_code == 3);
  CHECK(place.shell("cmp x.txt p/fewer.cnf && cmp r.yaml d/run-2.stigp").exit_code == 0);
}

TEST_CASE("validate writes over no file of its scene, and no file of it over another") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  const auto scene_with = [&](const std::string& program) {
    place.write(program, "function step() end\n");
    place.write("s.yaml",
                "stigc_scene: 1\nduration: 1\n"
                "robots: [{file: bebot.yaml, at: [0, 0], program: " +
                    program +
                    "}]\n"
                    "blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]\n");
    return "stigc validate " + rules + " --scene s.yaml -o ";
  };
  const std::vector<std::string> before = {"report.html", "s.yaml", "user.lua"};
  CHECK(place.shell(scene_with("report.html") + "out").exit_code == 2);
  CHECK(place.shell(scene_with("user.lua") + ".").exit_code == 2);
  CHECK(place.file("user.lua") == "function step() end\n");
  CHECK(place.files() == before);
}

TEST_CASE("what goes on may stand where it was: fmt --write, a resumed run") {
  const Workplace place;
  place.write("set.yaml", place.file("sets/corner.yaml"));
  CHECK(place.shell("ln -s set.yaml link; stigc fmt --write ./set.yaml link").exit_code == 0);
  CHECK(place.shell("stigc fmt --check set.yaml").exit_code == 0);
  REQUIRE(place.shell("stigc simulate sets/fall.yaml --duration 0.1 --trace t --checkpoint c")
              .exit_code == 0);
  const std::string first = place.file("c");
  CHECK(place.shell("stigc simulate --resume c --duration 0.2 --trace ./t --checkpoint ./c")
            .exit_code == 0);
  CHECK(place.file("c") != first);
  const std::string second = place.file("c");
  CHECK(place.shell("stigc simulate --resume c --duration 0.3 --trace c").exit_code != 0);
  CHECK(place.file("c") == second);
}

}  // namespace stig
