// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "program.h"
#include "support/uses.h"

namespace stig {

TEST_CASE("validate refuses what cannot be compiled as compile does, and runs nothing") {
  const Workplace place;
  const Outcome compile =
      place.stigc({"compile", STIG_SOURCE_DIR "/rulesets/order-dependent.yaml"});
  const Outcome validate =
      place.stigc({"validate", STIG_SOURCE_DIR "/rulesets/order-dependent.yaml", "-o", "out"});
  CHECK(validate.exit_code == 1);
  CHECK(validate.err == compile.err);
  CHECK(validate.out.empty());
  CHECK(place.files().empty());
}

TEST_CASE("validate says what a scene lacks") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  place.write("no-start.yaml",
              "stigc_scene: 1\nrobots: [{file: bebot.yaml, at: [0, 0], params: {side: +x}}]\n");
  const Outcome no_start = place.stigc({"validate", rules, "--scene", "no-start.yaml"});
  CHECK(no_start.exit_code == 1);
  CHECK(no_start.err.find("V801") != std::string::npos);
  place.write("no-side.yaml",
              "stigc_scene: 1\nrobots: [{file: bebot.yaml, at: [0, 0]}]\n"
              "blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]\n");
  const Outcome no_side = place.stigc({"validate", rules, "--scene", "no-side.yaml"});
  CHECK(no_side.exit_code == 1);
  CHECK(no_side.err.find("no-side.yaml:2:") != std::string::npos);
  CHECK(no_side.err.find("V802") != std::string::npos);
  const Outcome both = place.stigc({"validate", rules, "--scene", "no-side.yaml", "--robots", "2"});
  CHECK(both.exit_code == 2);
  CHECK(
      place.stigc({"validate", rules, "--scene", "no-side.yaml", "--structures", "2"}).exit_code ==
      2);
  CHECK(place.stigc({"validate", rules, "--runs", "0"}).exit_code == 2);
}

TEST_CASE("validate sets no robots to work that get in each other's way") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/tests/compiler/conflicts/walled.yaml";
  const Outcome two = place.stigc({"validate", rules, "--robots", "2"});
  CHECK(two.exit_code == 1);
  CHECK(two.err.find("error[P713]") != std::string::npos);
  const std::string start =
      "blocks:\n"
      "  - {at: [0, 0, 0.0275], color: Q1, fixed: true}\n"
      "  - {at: [0.33, -0.165, 0.0275], color: Q2, fixed: true}\n"
      "  - {at: [0.44, -0.165, 0.0275], color: Q1, fixed: true}\n"
      "robots:\n"
      "  - {name: one, file: bebot.yaml, at: [0.7, 0], params: {side: +x}}\n";
  place.write("one.yaml", "stigc_scene: 1\n" + start);
  place.write("two.yaml",
              "stigc_scene: 1\n" + start +
                  "  - {name: two, file: bebot.yaml, at: [0, 0.5], params: {side: +y}}\n");
  const std::vector<std::string> run = {"validate", rules, "--duration", "1", "--scene"};
  const auto with = [&](const std::string& scene) {
    std::vector<std::string> all = run;
    all.push_back(scene);
    return place.stigc(all);
  };
  const Outcome alone = with("one.yaml");
  CHECK(alone.err.find("warning[P714]") != std::string::npos);
  CHECK(alone.err.find("P713") == std::string::npos);
  CHECK(!alone.out.empty());
  const Outcome both = with("two.yaml");
  CHECK(both.exit_code == 1);
  CHECK(both.err.find("error[P713]") != std::string::npos);
  CHECK(both.out.empty());
}

TEST_CASE("a robot builds the staircase from its rules, and what was written runs the same") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  CHECK(place.stigc({"validate", rules, "-o", "out"}).exit_code == 0);
  const auto report = nlohmann::json::parse(place.file("out/report.json"));
  const auto& run = report["runs"][0];
  CHECK(run["end"] == "built");
  CHECK(run["missing"] == 0);
  CHECK(run["against"] == nullptr);
  CHECK(run["allowed"] == 5);
  CHECK(run["attempts"].size() >= 5);
  for (const auto& brick : run["bricks"]) CHECK(brick["shows"] == brick["brick"]);
  const std::string hash = run["hash"];
  const Outcome again = place.stigc(
      {"simulate", "out/scene.yaml", "--duration", std::to_string(run["time"].get<double>())});
  CHECK(again.out.find(hash) != std::string::npos);
}

TEST_CASE("several structures are set up, judged each by itself, and read from the scene again") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/stepped-pyramid.yaml";
  const Outcome made = place.stigc(
      {"validate", rules, "--structures", "3", "--robots", "7", "--duration", "2", "-o", "out"});
  CHECK(made.exit_code == 1);                         // nothing is built so soon
  CHECK(made.err.find("P715") == std::string::npos);  // three at one, which has four sides
  CHECK(made.out.find("structure 3 incomplete, at (-1.50, 1.50) m\n") != std::string::npos);
  CHECK(made.out.find("structure 2: missing: a Q3 brick at (0, 0, 1)") != std::string::npos);
  const auto report = nlohmann::json::parse(place.file("out/report.json"));
  CHECK(report["structures"] == 3);
  const auto& run = report["runs"][0];
  CHECK(run["robots"].size() == 7);
  REQUIRE(run["structures"].size() == 3);
  CHECK_FALSE(run.contains("bricks"));
  for (const auto& structure : run["structures"]) {
    CHECK(structure["verdict"] == "incomplete");
    CHECK(structure["bricks"].size() == 15);
    CHECK(structure["missing"] == 14);
    CHECK(structure["last_brick_s"] == nullptr);
  }
  // Given as a scene it is the same.
  const Outcome again = place.stigc({"validate", rules, "--scene", "out/scene.yaml", "--json"});
  CAPTURE(again.err);
  const auto second = nlohmann::json::parse(again.out);
  CHECK(second["runs"][0]["hash"] == run["hash"]);
  CHECK(second["runs"][0]["structures"] == run["structures"]);
}

// No look that its rules ask for has the top of its first brick in the picture.
TEST_CASE("a column's top is known by what is empty over it") {
  const Workplace place;
  const Outcome outcome = place.stigc(
      {"validate", STIG_SOURCE_DIR "/tests/compiler/tower.yaml", "--duration", "60", "--json"});
  const auto report = nlohmann::json::parse(outcome.out);
  CHECK(report["runs"][0]["placements"] == 1);
  CHECK(report["runs"][0]["allowed"] == 1);
}

TEST_CASE("a duration that was asked for is that of the scene that is written") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  place.write("idle.lua", "function step() end\n");
  const std::string things =
      "robots: [{file: bebot.yaml, at: [0, 0], program: idle.lua}]\n"
      "blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]\n";
  place.write("long.yaml", "stigc_scene: 1\nduration: 500  # s\n" + things);
  place.write("none.yaml", "stigc_scene: 1\n" + things);
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"validate", rules, "--duration", "1.5", "-o", "out"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = place.stigc(words);
    CHECK(outcome.exit_code == 1);  // nothing is built so soon
    const auto report = nlohmann::json::parse(place.file("out/report.json"));
    CHECK(report["runs"][0]["time"] == 1.5);
    const Outcome again = place.stigc({"simulate", "out/scene.yaml"});
    CHECK(again.out.find(report["runs"][0]["hash"].get<std::string>()) != std::string::npos);
    return place.file("out/scene.yaml");
  };
  CHECK(run({}).find("\nduration: 1.5\n") != std::string::npos);
  CHECK(run({"--scene", "long.yaml"}).find("\nduration: 1.5  # s\n") != std::string::npos);
  CHECK(run({"--scene", "none.yaml"}).find("\nduration: 1.5\n") != std::string::npos);
}

TEST_CASE("a scene in flow style gets the controller inside its braces") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  place.write("flow.yaml",
              "{stigc_scene: 1, robots: [{file: bebot.yaml, at: [0, 0], params: {side: +x}}],\n"
              " blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]}\n");
  const Outcome outcome =
      place.stigc({"validate", rules, "--scene", "flow.yaml", "--duration", "1", "-o", "out"});
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);  // nothing is built so soon
  CHECK(outcome.err.find("error[") == std::string::npos);
  CHECK(place.file("out/scene.yaml").find("{duration: 1, robot_program: ") == 0);
}

TEST_CASE("the later robot builds it too: what differs is data") {
  const Workplace place;
  CHECK(place
            .stigc({"validate", STIG_SOURCE_DIR "/rulesets/staircase.yaml", "--robot",
                    STIG_SOURCE_DIR "/robots/builderbot.yaml", "--runs", "2"})
            .exit_code == 0);
}

TEST_CASE("a robot that does nothing leaves the structure incomplete, and the report says so") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  place.shell("mkdir part");
  place.write("part/words.lua", "return { state = 'idle' }\n");
  place.write("idle.lua",
              "local words = require 'part.words'\n"
              "function step() robot.show.text('state', words.state) end\n");
  place.write("idle.yaml",
              "stigc_scene: 1\nduration: 3\n"
              "robots: [{file: bebot.yaml, at: [0, 0], program: idle.lua}]\n"
              "blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]\n");
  const Outcome idle =
      place.stigc({"validate", rules, "--scene", "idle.yaml", "--runs", "2", "-o", "out"});
  CHECK(idle.exit_code == 1);
  CHECK(idle.out.find("missing: a Q2 brick at (1, 0, 1)") != std::string::npos);
  CHECK(idle.out.find("bebot 1 is in state 'idle' since 0 s") != std::string::npos);
  CHECK(idle.out.find("no loose block") != std::string::npos);
  for (const char* name :
       {"out/report.html", "out/report.json", "out/progress.svg", "out/progress.csv",
        "out/scene.yaml", "out/part/words.lua", "out/run-1.stigp", "out/run-2.stigp"}) {
    CHECK_MESSAGE(place.has(name), name);
  }
  CHECK(place.stigc({"replay", "out/run-2.stigp", "--verify"}).exit_code == 0);
  // What was written runs the same.
  const Outcome json = place.stigc({"validate", rules, "--scene", "idle.yaml", "--json"});
  const std::size_t at = json.out.find("\"hash\": \"");
  REQUIRE(at != std::string::npos);
  const std::string hash = json.out.substr(at + 9, 16);
  CHECK(place.stigc({"simulate", "out/scene.yaml"}).out.find(hash) != std::string::npos);
  CHECK(place.stigc({"validate", rules, "--scene", "idle.yaml", "--runs", "2", "--threads", "1"})
            .out ==
        place.stigc({"validate", rules, "--scene", "idle.yaml", "--runs", "2", "--threads", "2"})
            .out);
}

TEST_CASE("a robot is idle when it does nothing for long, whatever it says") {
  const Workplace place;
  place.write("idle.lua", "function step() robot.show.text('state', 'hard at work') end\n");
  // Still for three seconds and more, time and again.
  place.write("slow.lua",
              "local n = 0\n"
              "function step()\n"
              "   n = n + 1\n"
              "   local v = n % 20 < 2 and 0.05 or 0\n"
              "   robot.differential_drive.set_target_velocity(v, -v)\n"
              "   robot.show.text('state', 'slow')\n"
              "   robot.show.number('busy', n // 20)\n"
              "end\n");
  place.write("two.yaml",
              "stigc_scene: 1\nduration: 10\n"
              "robots:\n"
              "  - {file: bebot.yaml, at: [0, 0], program: idle.lua}\n"
              "  - {file: bebot.yaml, at: [0.5, 0], program: slow.lua}\n"
              "blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]\n");
  const Outcome two = place.stigc(
      {"validate", STIG_SOURCE_DIR "/rulesets/staircase.yaml", "--scene", "two.yaml", "--json"});
  const auto report = nlohmann::json::parse(two.out);
  const auto& robots = report["runs"][0]["robots"];
  CHECK(robots[0]["idle_s"].get<double>() > 9);
  CHECK(robots[0]["idle_states_s"]["hard at work"].get<double>() > 9);
  CHECK(robots[1]["idle_s"] == 0);
  CHECK(robots[1]["still_s"].get<double>() > 6);
  CHECK(robots[1]["busy_at"].size() == 2);
  CHECK(report["summary"]["idle_share"].get<double>() == doctest::Approx(0.5).epsilon(0.1));
  CHECK(report["summary"]["busy"] == 2);
  CHECK(report["summary"]["states"].size() == 2);
  CHECK(report["summary"]["finish_s"] == nullptr);
}

TEST_CASE("a file of the user's that is called controller.lua is not left out without a word") {
  const Workplace place;
  const std::string rules = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  const std::string start = "blocks: [{at: [-0.15, 0, 0.0275], color: Q3, fixed: true}]\n";
  place.write("controller.lua", "function step() robot.show.text('state', 'mine') end\n");
  place.write("uses.lua", "local mine = require 'controller'\nfunction step() end\n");
  const auto validated = [&](const std::string& robot) {
    place.write("s.yaml", "stigc_scene: 1\nduration: 1\nrobots: [{file: bebot.yaml, at: [0, 0], " +
                              robot + "}]\n" + start);
    return place.stigc({"validate", rules, "--scene", "s.yaml"});
  };
  for (const char* robot : {"program: controller.lua, params: {side: +x}", "program: uses.lua"}) {
    CAPTURE(robot);
    const Outcome named = validated(robot);
    CHECK(named.exit_code == 1);
    CHECK(named.out.empty());
    CHECK(named.err.find("'s.yaml' asks for 'controller.lua'") != std::string::npos);
  }
  // A scene that does not name it runs what was compiled, as does one that names no such file.
  CHECK(validated("params: {side: +x}").out.find("'mine'") == std::string::npos);
  CHECK(!validated("params: {side: +x}").out.empty());
  place.shell("rm controller.lua");
  CHECK(!validated("program: controller.lua, params: {side: +x}").out.empty());
  // So does one beside the very program.
  REQUIRE(place.shell("stigc compile " + rules + " -o controller.lua").exit_code == 0);
  CHECK(!validated("program: controller.lua, params: {side: +x}").out.empty());
}

TEST_CASE("a program without its viewer writes reports with pictures, and says so") {
  namespace fs = std::filesystem;
  const Workplace place;
  place.shell("mkdir -p bare/bin bare/share/stig");
  fs::copy_file(STIGC_PROGRAM, place.path("bare/bin/stigc"));
  for (const char* kind : {"rulesets", "scenes", "robots", "blocks", "programs"}) {
    fs::create_symlink(fs::path(STIG_SOURCE_DIR) / kind, place.path("bare/share/stig/") + kind);
  }
  const Outcome outcome =
      place.shell("bare/bin/stigc validate rulesets/staircase.yaml --duration 1 -o out --quiet");
  CHECK(outcome.exit_code == 1);
  const std::string report = place.file("out/report.html");
  CHECK(report.find("built without its viewer") != std::string::npos);
  CHECK(report.find("<img alt=\"after 1 s\" src=\"data:image/png;base64,") != std::string::npos);
  CHECK(report.find("<script") == std::string::npos);
}

TEST_CASE("a scene's script that fails is no failure of the robots") {
  const Workplace place;
  const std::string command = "stigc validate " STIG_SOURCE_DIR "/rulesets/staircase.yaml ";
  REQUIRE(place.shell(command + "--duration 1 -o out").exit_code == 1);
  const auto with_script = [&](const std::string& script) {
    place.write("out/script.lua", script);
    return place.shell(command + "--duration 1 --scene out/scene.yaml");
  };
  REQUIRE(
      place.shell("rm out/controller.lua; echo 'script: script.lua' >> out/scene.yaml").exit_code ==
      0);
  const Outcome failed = with_script("function on_step(world) local x = nil + 1 end\n");
  CHECK(failed.exit_code == 3);
  CHECK(failed.out.find("the scene's script failed: script.lua:1: ") != std::string::npos);
  const Outcome late = with_script("function on_end(world) local x = nil + 1 end\n");
  CHECK(late.exit_code == 3);
  const Outcome stopped = with_script("function on_step(world) world.stop('enough') end\n");
  CHECK(stopped.exit_code == 1);
  CHECK(stopped.out.find("the scene's script ended the run: enough") != std::string::npos);
}

TEST_CASE("validate says where a scene's robots are others than the program is compiled for") {
  const Workplace place;
  const std::string command = "stigc validate " STIG_SOURCE_DIR "/rulesets/staircase.yaml ";
  REQUIRE(place.shell(command + "--duration 1 -o out").exit_code == 1);
  REQUIRE(place.shell("rm out/controller.lua").exit_code == 0);
  const std::string again = command + "--duration 1 --scene out/scene.yaml";
  CHECK(place.shell(again).err.find("compiled for") == std::string::npos);
  const Outcome other = place.shell(again + " --robot " STIG_SOURCE_DIR "/robots/builderbot.yaml");
  CHECK(other.err.find("'robot 1' is a 'bebot', and its program is compiled for a 'builderbot'") !=
        std::string::npos);
}

TEST_CASE("validate writes over its own earlier results, and over no others") {
  const Workplace place;
  const std::string command =
      "stigc validate " STIG_SOURCE_DIR "/rulesets/staircase.yaml --duration 1 -o ";
  for (const std::string name : {"controller.lua", "scene.yaml", "report.html", "report.json"}) {
    CAPTURE(name);
    REQUIRE(place.shell("mkdir mine; echo mine > mine/" + name).exit_code == 0);
    const Outcome outcome = place.shell(command + "mine");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("'mine/" + name + "' is there already") != std::string::npos);
    CHECK(place.file("mine/" + name) == "mine\n");
    place.shell("rm -r mine");
  }
  REQUIRE(place.shell("mkdir out; echo kept > out/notes.txt").exit_code == 0);
  CHECK(place.shell(command + "out").exit_code == 1);
  const Outcome second = place.shell(command + "out --seed 2");
  CHECK(second.exit_code == 1);
  CHECK(place.has("out/run-2.stigp"));
  CHECK(second.err.find("of an earlier validation, and not in the report: run-1.stigp\n") !=
        std::string::npos);
  CHECK(place.has("out/run-1.stigp"));
  CHECK(place.file("out/notes.txt") == "kept\n");
}

/// Its trace is there, and its line in the journal, which comes after.
static bool a_run_is_over(const Workplace& place) {
  const Outcome lines = place.shell("ls some/run-*.stigp && wc -l < some/runs.journal");
  return lines.exit_code == 0 && lines.out.find("\n1\n") == std::string::npos;
}

TEST_CASE("a validation that is killed again and again ends in the report of one that was not") {
  const Workplace place;
  // Three processes work on it for half a second each, the last until there is a trace; the whole
  // is to be more than that.
  const std::string line = "validate " STIG_SOURCE_DIR
                           "/rulesets/staircase.yaml --runs 24 "
                           "--duration 30 --json -q -o ";
  const Outcome whole = place.shell("stigc " + line + "whole");
  CHECK(whole.exit_code == 1);
  for (int k = 0; k < 3; ++k) {
    const pid_t validate =
        place.start({"validate", STIG_SOURCE_DIR "/rulesets/staircase.yaml", "--runs", "24",
                     "--duration", "30", "--json", "-q", "-o", "some"});
    Workplace::let_work(validate);
    for (int waits = 0; k == 2 && waits < 6000 && !a_run_is_over(place); ++waits) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ::kill(validate, SIGKILL);
    place.finish(validate);
  }
  REQUIRE(a_run_is_over(place));
  // A trace that was damaged meanwhile is made anew.
  REQUIRE(place.shell("for f in some/run-*.stigp; do truncate -s 1000 $f; break; done").exit_code ==
          0);
  const Outcome again = place.shell("stigc " + line + "some --threads 1");
  CAPTURE(again.err);
  CHECK(again.exit_code == 1);
  CHECK(again.out == whole.out);
  CHECK(place.shell("diff -r whole some").out.empty());
  CHECK_FALSE(place.has("some/runs.journal"));
  // One of them alone is the same run.
  const Outcome alone = place.shell("stigc validate " STIG_SOURCE_DIR
                                    "/rulesets/staircase.yaml --duration 30 --run 4 --json");
  CHECK(nlohmann::json::parse(alone.out).at("runs").at(0) ==
        nlohmann::json::parse(whole.out).at("runs").at(4));
  CHECK(place.shell("stigc " + line + "whole --run 1").exit_code == 2);
}

}  // namespace stig
