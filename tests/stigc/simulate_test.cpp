// SPDX-License-Identifier: MIT
// stigc simulate and what reads its files.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "support/golden.h"
#include "support/mcap.h"
#include "support/uses.h"

namespace stig {
namespace {

/// What differs from run to run, and what every change of the physics' last digits changes.
constexpr const char* kSteady =
    " | sed -E '/^ *speed /d; s/([ \"])[0-9a-f]{16}(\"?,?)$/\\1HASH\\2/; s/^( *size ).*/\\1X/; "
    "s/\"(at|seconds|real_time_factor|bytes[a-z_]*|[a-z]*_mm|[a-z]*_degrees)\": "
    "([0-9.e+-]+|\\[[^]]*\\])/\"\\1\": X/'";

/// The line of a summary that begins with `label`.
std::string line_of(const std::string& text, const std::string& label) {
  const std::size_t at = text.find("  " + label + " ");
  REQUIRE_MESSAGE(at != std::string::npos, text);
  return text.substr(at, text.find('\n', at) - at);
}

}  // namespace

TEST_CASE("simulate prints a summary, one object, or a table of runs") {
  const Workplace place;
  hold(place, "simulate", "stigc simulate sets/still.yaml" + std::string(kSteady));
  hold(place, "simulate-json",
       "stigc simulate sets/still.yaml --duration 0.2 --seed 4 --json" + std::string(kSteady));
  hold(place, "simulate-runs", "stigc simulate sets/still.yaml --runs 3" + std::string(kSteady));
  hold(place, "simulate-bad",
       "stigc simulate sets/stuck.yaml; stigc check sets/stuck.yaml sets/fall.yaml");
  CHECK(place.stigc({"simulate", "sets/fall.yaml", "--runs", "3", "--threads", "1"}).out ==
        place.stigc({"simulate", "sets/fall.yaml", "--runs", "3", "--threads", "2"}).out);
}

TEST_CASE("programs that cannot run are reported with their lines and the scene's") {
  const Workplace place;
  place.write("slip.lua", "local lit = 1\n\nfunction on_step()\n  lit = 2\nend\n");
  place.write("torn.lua", "function step()\n  local lit = = 1\nend\n");
  const std::string scene =
      "title: Programs\nstigc_scene: 1\nblocks: [{at: [0, 0, 0.0275]}]\nblock_program: ";
  place.write("slip.yaml", scene + "slip.lua\n");
  place.write("torn.yaml", scene + "torn.lua\n");
  hold(place, "check-programs", "stigc check slip.yaml torn.yaml; stigc simulate slip.yaml");
}

TEST_CASE("replay shows a recorded run, any moment of it, and verifies it") {
  const Workplace place;
  hold(place, "simulate-replay",
       "{ stigc simulate -q sets/still.yaml --trace t.stigp > /dev/null; stigc replay t.stigp; "
       "stigc replay t.stigp --verify; stigc replay t.stigp --at 0.25; }" +
           std::string(kSteady));
  hold(place, "simulate-replay-json",
       "{ stigc replay t.stigp --json; stigc replay t.stigp --verify --json; }" +
           std::string(kSteady));
  hold(place, "simulate-damaged",
       "head -c 400 t.stigp > d.stigp; stigc replay d.stigp; "
       "stigc simulate -q sets/fall.yaml --duration 0.1 --checkpoint c.stigk > /dev/null; "
       "head -c 300 c.stigk > d.stigk; stigc simulate --resume d.stigk; "
       "stigc simulate --resume t.stigp; stigc simulate --resume c.stigk --trace t2.stigp; "
       "stigc simulate -q sets/fall.yaml --seed 2 --trace t2.stigp > /dev/null; "
       "stigc simulate --resume c.stigk --trace t2.stigp");
}

TEST_CASE("a run taken up again ends as if it had never stopped: hash and trace, byte by byte") {
  for (const std::string detail : {"", " --trace-detail"}) {
    const Workplace place;
    const Outcome whole = place.shell("stigc simulate sets/fall.yaml --trace whole.stigp" + detail);
    REQUIRE(whole.exit_code == 0);
    REQUIRE(place
                .shell("stigc simulate sets/fall.yaml --duration 0.4 --trace part.stigp "
                       "--checkpoint c.stigk" +
                       detail)
                .exit_code == 0);
    // What is recorded is what the trace so far has.
    const Outcome rest = place.stigc(
        {"simulate", "--resume", "c.stigk", "--trace", "part.stigp", "--duration", "1"});
    CHECK(rest.exit_code == 0);
    for (const char* label : {"hash", "moved", "contacts", "magnets", "end"}) {
      CHECK(line_of(rest.out, label) == line_of(whole.out, label));
    }
    CHECK(place.file("part.stigp") == place.file("whole.stigp"));
  }
}

TEST_CASE("pictures of any moment, from a run and from its trace, are the same") {
  const Workplace place;
  REQUIRE(
      place
          .stigc({"simulate", "sets/fall.yaml", "--trace", "t.stigp", "-o", "a.png", "--at", "0.3"})
          .exit_code == 0);
  REQUIRE(place.stigc({"replay", "t.stigp", "-o", "b.png", "--at", "0.3"}).exit_code == 0);
  CHECK(place.file("a.png").starts_with("\x89PNG"));
  CHECK(place.file("b.png").starts_with("\x89PNG"));
  REQUIRE(place.stigc({"replay", "t.stigp", "-o", "c.png"}).exit_code == 0);
  CHECK(place.file("c.png") != place.file("b.png"));
}

TEST_CASE("an interrupted run keeps its trace and leaves a checkpoint to go on from") {
  const Workplace place;
  const pid_t process = place.start({"simulate", "sets/fall.yaml", "--duration", "1000000",
                                     "--trace", "t.stigp", "--checkpoint", "c.stigk"});
  Workplace::let_work(process);
  kill(process, SIGINT);
  const Outcome outcome = place.finish(process);
  CHECK(outcome.exit_code == 3);
  CHECK(outcome.err.find("interrupted after") != std::string::npos);
  CHECK(place.stigc({"replay", "t.stigp", "--verify"}).exit_code == 0);
  CHECK(place.files() == std::vector<std::string>{"c.stigk", "t.stigp"});
  CHECK(place.stigc({"simulate", "--resume", "c.stigk", "--duration", "1"}).exit_code == 0);
}

TEST_CASE("a second signal ends the program at once, and leaves no half file") {
  const Workplace place;
  const pid_t process =
      place.start({"simulate", "sets/fall.yaml", "--duration", "1000000", "--trace", "t.stigp"});
  Workplace::let_work(process);
  REQUIRE(place.files().size() == 1);
  // Both at the same time: the first is not acted on before the second is there.
  kill(process, SIGSTOP);
  kill(process, SIGINT);
  kill(process, SIGTERM);
  kill(process, SIGCONT);
  CHECK(place.finish(process).exit_code == -1);  // of a signal
  CHECK(place.files().empty());
}

TEST_CASE("simulate's usage errors") {
  const Workplace place;
  hold(place, "simulate-usage",
       "{ for words in '' 'sets/fall.yaml --at 1' 'sets/fall.yaml -o x.svg' "
       "'sets/fall.yaml --runs 2 --trace t' 'sets/fall.yaml --resume c' '--resume c --seed 1' "
       "'sets/fall.yaml --duration 0' 'sets/fall.yaml --trace no/such/t' "
       "'sets/none.yaml' 'sets/line.yaml'; do "
       "echo \"stigc simulate $words\"; stigc simulate $words; echo \"  exit $?\"; done; } 2>&1");
  REQUIRE(place.stigc({"explore", "sets/line.yaml", "--trace", "l.stigt"}).exit_code == 0);
  CHECK(place.stigc({"replay", "l.stigt", "--at", "1"}).exit_code == 2);
}

TEST_CASE("a trace's poses become a table that others read") {
  const Workplace place;
  REQUIRE(place
              .shell("stigc simulate scenes/robot-fetch.yaml --duration 0.5 --trace f.stigp && "
                     "stigc replay f.stigp -o f.csv -o f.png --at 0.2")
              .exit_code == 0);
  CHECK(place.file("f.csv").starts_with("time,body,kind,x,y,z,qw,qx,qy,qz,awake\n0.000000,"));
  const Outcome read = place.shell("python3 " STIG_SOURCE_DIR "/tests/readers/pose_table.py f.csv");
  CHECK_MESSAGE(read.exit_code == 0, read.err);
  // The cache drops its block in the first tick.
  for (const std::string rows : {"bebot 1/lower chassis (robot): 26 rows, 0.5 s, ",
                                 "cache block 1 (block): 25 rows, 0.5 s, "}) {
    CHECK_MESSAGE(read.out.find(rows) != std::string::npos, read.out);
  }
  CHECK(read.out.find("\nblock 1") == std::string::npos);  // fixed
  // The last rows are what the trace's end is, as JSON has it.
  const auto end =
      nlohmann::json::parse(place.stigc({"replay", "f.stigp", "--at", "9", "--json"}).out);
  for (const auto& body : end["moment"]["bodies"]) {
    if (body["name"] == "block 1") continue;  // fixed
    CAPTURE(body["name"].get<std::string>());
    const std::string at = fmt::format("{:.5f} {:.5f} {:.5f}\n", body["at"][0].get<double>(),
                                       body["at"][1].get<double>(), body["at"][2].get<double>());
    CHECK(read.out.find(at) != std::string::npos);
  }
  CHECK(place.shell("stigc replay f.stigp -o f.csv -o f.csv").exit_code == 2);
  CHECK(place.stigc({"replay", "f.stigp", "-o", "f.svg"}).exit_code == 2);
}

TEST_CASE("a trace becomes an MCAP file when it is whole, and none when it is not") {
  const Workplace place;
  REQUIRE(place
              .shell("stigc simulate scenes/robot-fetch.yaml --duration 0.5 --trace f.stigp && "
                     "stigc replay f.stigp -o f.mcap -o again.mcap")
              .exit_code == 0);
  const McapContent content = mcap_content(place.file("f.mcap"));
  CHECK(place.file("f.mcap") == place.file("again.mcap"));
  CHECK(content.of("/tf").size() == 26);
  CHECK(content.facts.at("title") == "A robot fetches a block");
  place.shell("head -c 3000 f.stigp > half.stigp; head -c 40 f.stigp > cut.stigp");
  for (const char* name : {"half.stigp", "cut.stigp"}) {
    const Outcome bad = place.stigc({"replay", name, "-o", "bad.mcap"});
    CHECK(bad.exit_code == 1);
    CHECK(bad.err.find("error[F480]: not a readable trace of poses") != std::string::npos);
    CHECK(!place.has("bad.mcap"));
  }
  CHECK(place.stigc({"replay", "f.stigp", "-o", "no/such/f.mcap"}).exit_code != 0);
}

TEST_CASE("the schema of scenes") {
  const Workplace place;
  check_golden("tests/golden/scene-schema.json", place.stigc({"schema", "scene"}).out);
}

TEST_CASE("robots that meet head on in a corridor get past each other, and none falls over") {
  const Workplace place;
  const Outcome runs = place.stigc(
      {"simulate", STIG_SOURCE_DIR "/scenes/faults/robots-head-on.yaml", "--runs", "4", "--json"});
  REQUIRE(runs.exit_code == 0);
  const auto report = nlohmann::json::parse(runs.out);
  REQUIRE(report["runs"].size() == 4);
  for (const auto& run : report["runs"]) {
    CAPTURE(run["seed"].get<int>());
    CHECK(run["message"] == "both are through");
    CHECK(run["measures"]["through"] == 2);
  }
}

}  // namespace stig
