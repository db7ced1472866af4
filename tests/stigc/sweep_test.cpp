// SPDX-License-Identifier: MIT
// Studies: what an item is, and that nothing about how items are done reaches a record.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "program.h"
#include "support/uses.h"

namespace stig {
namespace {

using Json = nlohmann::json;

/// 12 items of explore, quick ones.
const std::string kPlan =
    "stigc_sweep: 1\nname: corner\ncommand: explore\nfile: sets/corner.yaml\n"
    "options: {box: [9, 9, 9], steps: 20000}\n"
    "vary:\n  agents: [1, 5]\n  motion: [walk, teleport]\n  seed: 1..3\n";

/// Items that take some milliseconds each.
const std::string kSlowPlan =
    "stigc_sweep: 1\ncommand: explore\nfile: sets/corner.yaml\n"
    "options: {agents: 1, box: [60, 60, 60], steps: 200000}\nvary: {seed: 1..60}\n";

std::vector<Json> records(const Workplace& place, const std::string& name) {
  std::vector<Json> out;
  std::istringstream lines(place.file(name));
  for (std::string line; std::getline(lines, line);) out.push_back(Json::parse(line));
  return out;
}

TEST_CASE("a record says of an item all that there is to say, and its command line does it again") {
  const Workplace place;
  place.write("plan.yaml", kPlan);
  const Outcome outcome = place.shell("stigc sweep plan.yaml -o all.jsonl -o all.csv");
  REQUIRE(outcome.exit_code == 0);
  const std::vector<Json> all = records(place, "all.jsonl");
  REQUIRE(all.size() == 12);
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i].at("item") == i);
    CHECK(all[i].at("items") == 12);
    CHECK(all[i].at("plan") == all[0].at("plan"));
    CHECK(all[i].at("options").at("steps") == 20000);
    CHECK(all[i].at("set").at("seed") == i % 3 + 1);
    CHECK(all[i].at("seed") == i % 3 + 1);
    CHECK(all[i].at("set").at("agents") == (i < 6 ? 1 : 5));
    CHECK(all[i].at("exit") == 0);
    CHECK(all[i].at("ruleset_hash") == all[i].at("result").at("ruleset_hash"));
  }
  const Outcome again = place.shell(all[7].at("command").get<std::string>() + " --json");
  CHECK(Json::parse(again.out) == all[7].at("result"));
  const std::string csv = place.file("all.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 13);
  CHECK(csv.find(",set.motion,") != std::string::npos);
  CHECK(csv.find(",result.measures.components,") != std::string::npos);
  CHECK(place.shell("stigc sweep plan.yaml --run 7").out == place.shell("sed -n 8p all.jsonl").out);
}

TEST_CASE("records are the same for any number of threads, and for slices that are merged") {
  const Workplace place;
  place.write("plan.yaml", kPlan);
  REQUIRE(place.shell("stigc sweep plan.yaml -o all.jsonl -o all.csv > all.out").exit_code == 0);
  place.shell("stigc sweep plan.yaml --threads 1 -o one.jsonl -o one.csv > one.out");
  for (const char* part : {"1", "2", "3"}) {
    place.shell(std::string("stigc sweep plan.yaml -o part-") + part + ".jsonl --slice " + part +
                "/3");
  }
  place.shell("stigc merge part-3.jsonl part-1.jsonl part-2.jsonl -o m.jsonl -o m.csv > m.out");
  for (const char* other : {"one", "m"}) {
    for (const char* ending : {".jsonl", ".csv", ".out"}) {
      CHECK(place.file("all" + std::string(ending)) == place.file(other + std::string(ending)));
    }
  }
  const Outcome lacking = place.shell("stigc merge part-1.jsonl part-3.jsonl -o less.jsonl");
  CHECK(lacking.exit_code == 1);
  CHECK(lacking.err.find("item 1 of 12 is in none of these") != std::string::npos);
  CHECK_FALSE(place.has("less.jsonl"));
}

TEST_CASE("slices of other plans, and files that are none, are not merged") {
  const Workplace place;
  place.write("plan.yaml", kPlan);
  place.write("other.yaml", kPlan + "sample: 12\n");
  place.shell("stigc sweep plan.yaml --slice 1/2 -o a.jsonl");
  place.shell("stigc sweep other.yaml --slice 2/2 -o b.jsonl");
  place.write("c.jsonl", "{\"item\": -1}\n");
  CHECK(place.shell("stigc merge a.jsonl b.jsonl -o m.jsonl").err.find("of another plan") !=
        std::string::npos);
  CHECK(place.shell("stigc merge a.jsonl c.jsonl -o m.jsonl").err.find("no record") !=
        std::string::npos);
  CHECK(place.shell("stigc merge a.jsonl none.jsonl -o m.jsonl").exit_code == 1);
  CHECK_FALSE(place.has("m.jsonl"));
}

TEST_CASE("a study that is killed again and again ends in the bytes of one that was not") {
  const Workplace place;
  place.write("plan.yaml", kSlowPlan);
  REQUIRE(place.shell("stigc sweep plan.yaml -q -o whole.jsonl -o whole.csv").exit_code == 0);
  const std::string line = std::string(STIGC_PROGRAM) +
                           " sweep plan.yaml -q -o some.jsonl "
                           "-o some.csv";
  for (const char* seconds : {"0.05", "0.25", "0.3", "0.35", "0.4"}) {
    place.shell("timeout -s KILL " + std::string(seconds) + " " + line);
  }
  CHECK(place.shell("timeout -s INT 0.3 " + line).exit_code != 1);
  CHECK(place.shell(line).exit_code == 0);
  CHECK(place.file("whole.jsonl") == place.file("some.jsonl"));
  CHECK(place.file("whole.csv") == place.file("some.csv"));
  CHECK_FALSE(place.has("some.jsonl.journal"));
}

TEST_CASE("a journal has one writer at a time, and belongs to its plan") {
  const Workplace place;
  place.write("plan.yaml", kSlowPlan);
  place.write("other.yaml", kSlowPlan + "sample: 3\n");
  const pid_t first = place.start({"sweep", "plan.yaml", "-o", "r.jsonl", "--threads", "1"});
  Workplace::let_work(first);
  const Outcome second = place.stigc({"sweep", "plan.yaml", "-o", "r.jsonl"});
  place.shell("kill -9 " + std::to_string(first));
  place.finish(first);
  // A machine that was done by then has no journal left.
  if (!place.has("r.jsonl.journal")) return;
  CHECK(second.exit_code == 3);
  CHECK(second.err.find("is in use") != std::string::npos);
  CHECK(place.stigc({"sweep", "other.yaml", "-o", "r.jsonl"}).exit_code == 3);
}

TEST_CASE("values in files vary by their paths, and where they were not written") {
  const Workplace place;
  place.write("plan.yaml",
              "stigc_sweep: 1\ncommand: explore\nfile: " STIG_SOURCE_DIR
              "/rulesets/coral.yaml\n"
              "options: {steps: 3000, agents: 5}\nvary:\n"
              "  rules.sprout.probability: [0.2, 0.9]\n  rules.grow up.probability: 0.5..1/2\n");
  REQUIRE(place.shell("stigc sweep plan.yaml -o all.jsonl").exit_code == 0);
  const std::vector<Json> all = records(place, "all.jsonl");
  REQUIRE(all.size() == 4);
  CHECK(all[0].at("ruleset_hash") != all[1].at("ruleset_hash"));
  CHECK(all[0].at("ruleset_hash") != all[2].at("ruleset_hash"));
  // 0.2 is what the file has, and 1 what it means where nothing is said.
  const Outcome plain = place.shell("stigc explore " STIG_SOURCE_DIR
                                    "/rulesets/coral.yaml --steps 3000 --agents 5 --json");
  CHECK(Json::parse(plain.out).at("structure_hash") == all[1].at("result").at("structure_hash"));
}

TEST_CASE("every command that is studied gives records") {
  const Workplace place;
  place.write("square.txt", "1 1\n1 1\n");
  const std::string stairs = STIG_SOURCE_DIR "/rulesets/staircase.yaml";
  const std::pair<std::string, std::string> plans[] = {
      {"command: verify\nfile: " + stairs + "\nvary: {effort: [0.5, 1]}\n", "verdict"},
      {"command: synth\nfile: square.txt\nvary: {fewest: [rules, colours]}\n", "verdict"},
      {"command: compile\nfile: " + stairs + "\nvary: {robots: 1..2}\n", "decision"},
      {"command: validate\nfile: " + stairs + "\noptions: {duration: 3}\nvary: {seed: 1..2}\n",
       "runs"}};
  for (const auto& [plan, key] : plans) {
    CAPTURE(plan);
    place.write("plan.yaml", "stigc_sweep: 1\n" + plan);
    CHECK(place.shell("stigc sweep plan.yaml -o all.jsonl").exit_code == 0);
    const std::vector<Json> all = records(place, "all.jsonl");
    REQUIRE(all.size() == 2);
    CHECK(all[1].at("result").contains(key));
    CHECK(all[1].at("options").is_object());
  }
}

TEST_CASE("what a command refuses is a record, too") {
  const Workplace place;
  place.write("plan.yaml",
              "stigc_sweep: 1\ncommand: compile\nvary: {file: [sets/corner.yaml, "
              "sets/line.yaml]}\n");
  CHECK(place.shell("stigc sweep plan.yaml -o all.jsonl").exit_code == 0);
  const std::vector<Json> all = records(place, "all.jsonl");
  REQUIRE(all.size() == 2);
  CHECK(all[0].at("exit") == 1);
  CHECK(all[0].at("codes").size() >= 1);
  CHECK(all[0].at("message").get<std::string>().find("error") != std::string::npos);
}

TEST_CASE("a sample draws from ranges and lists, each item by its own number") {
  const Workplace place;
  const std::string plan =
      "stigc_sweep: 1\ncommand: explore\nfile: sets/corner.yaml\noptions: {box: [9, 9, 9]}\n"
      "vary: {steps: 10..90, seed: [4, 6]}\nsample: ";
  place.write("plan.yaml", plan + "40\n");
  place.write("more.yaml", plan + "41\n");
  REQUIRE(place.shell("stigc sweep plan.yaml -o all.jsonl").exit_code == 0);
  REQUIRE(place.shell("stigc sweep more.yaml -o more.jsonl").exit_code == 0);
  const std::vector<Json> all = records(place, "all.jsonl"), more = records(place, "more.jsonl");
  REQUIRE(all.size() == 40);
  std::set<int> steps, seeds;
  for (std::size_t i = 0; i < all.size(); ++i) {
    steps.insert(all[i].at("set").at("steps").get<int>());
    seeds.insert(all[i].at("set").at("seed").get<int>());
    CHECK(all[i].at("set") == more[i].at("set"));
  }
  CHECK(*steps.begin() >= 10);
  CHECK(*steps.rbegin() <= 90);
  CHECK(steps.size() > 10);
  CHECK(seeds == std::set<int>{4, 6});
}

TEST_CASE("what is wrong with a plan is said before the work") {
  const Workplace place;
  const std::string head = "stigc_sweep: 1\ncommand: explore\nfile: sets/corner.yaml\n";
  const std::pair<std::string, std::string> plans[] = {
      {head + "vary: {agent: [1]}\n", "did you mean 'agents'?"},
      {head + "vary: {threads: [1]}\n", "no option of explore that items can have"},
      {head + "vary: {agents: [0]}\n", "agents"},
      {head + "vary: {seed: 5..1}\n", "from the lower number to the higher one"},
      {head + "vary: {seed: 1..9000000}\n", "at most 1000000 values"},
      {head + "vary: {seed: many}\n", "takes a list of values or a range"},
      {head + "vary: {rules.none.place: [1]}\n", "there is no 'none'"},
      {head + "vary: {robot.levels: [1]}\n", "in a file that the study does not name"},
      {head + "vary: {steps: 0.5..0.9}\n", "has no number of values"},
      {head + "vary: {}\n", "nothing varies"},
      {head + "vary: {file: [sets/line.yaml]}\n", "has a 'file', or varies it"},
      {head + "options: 3\nvary: {seed: 1..2}\n", "'options' takes a mapping"},
      {"stigc_sweep: 1\ncommand: draw\nfile: x\nvary: {seed: 1..2}\n", "explore"},
      {"stigc_sweep: 1\ncommand: explore\nfile: none.yaml\nvary: {seed: 1..2}\n", "cannot open"}};
  for (const auto& [plan, words] : plans) {
    CAPTURE(plan);
    place.write("plan.yaml", plan);
    const Outcome outcome = place.stigc({"sweep", "plan.yaml", "-o", "all.jsonl"});
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.find(words) != std::string::npos);
    CHECK_FALSE(place.has("all.jsonl.journal"));
  }
  place.write("plan.yaml", kPlan);
  CHECK(place.stigc({"sweep", "plan.yaml"}).exit_code == 2);
  CHECK(place.stigc({"sweep", "plan.yaml", "--run", "12"}).exit_code == 2);
  CHECK(place.stigc({"sweep", "plan.yaml", "-o", "all.txt"}).exit_code == 2);
  CHECK(place.stigc({"sweep", "plan.yaml", "-o", "plan.yaml.csv", "--slice", "3/2"}).exit_code ==
        2);
}

}  // namespace
}  // namespace stig
