// SPDX-License-Identifier: MIT
// Ensembles of explore: nothing that is done is lost, however the program ends.
#include <doctest/doctest.h>
#include <signal.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.h"
#include "support/uses.h"

namespace stig {
namespace {

/// Runs that take some milliseconds each, and what writes their tables.
const std::string kEnsemble =
    "stigc explore sets/corner.yaml --agents 1 --box 60,60,60 --steps 200000 --runs 60 ";

TEST_CASE("an ensemble that is killed again and again ends in the bytes of one that was not") {
  const Workplace place;
  REQUIRE(place.shell(kEnsemble + "-q -o whole.csv -o whole.jsonl > whole.out").exit_code == 0);
  for (const char* seconds : {"0.02", "0.05", "0.1", "0.15", "0.2", "0.3"}) {
    place.shell("timeout -s KILL " + std::string(seconds) + " " + STIGC_PROGRAM +
                kEnsemble.substr(5) + "-q -o some.csv -o some.jsonl --threads 2");
  }
  CHECK(place.shell(kEnsemble + "-q -o some.csv -o some.jsonl --threads 1 > some.out").exit_code ==
        0);
  for (const char* ending : {"csv", "jsonl", "out"}) {
    CHECK(place.shell(std::string("cmp whole.") + ending + " some." + ending).exit_code == 0);
  }
  CHECK(place.shell("ls | grep -c journal").out == "0\n");
}

TEST_CASE("an interrupted ensemble says how it goes on, and its records are whole") {
  const Workplace place;
  const pid_t ensemble =
      place.start({"explore", "sets/corner.yaml", "--agents", "1", "--box", "60,60,60", "--steps",
                   "200000", "--runs", "600", "--threads", "1", "-o", "some.jsonl"});
  Workplace::let_work(ensemble);
  ::kill(ensemble, SIGINT);
  const Outcome outcome = place.finish(ensemble);
  if (outcome.exit_code == 0) return;  // a machine that was done by then
  CHECK(outcome.err.find("the same command goes on") != std::string::npos);
  CHECK(outcome.exit_code == 3);
  const Outcome again = place.shell(
      "stigc explore sets/corner.yaml --agents 1 --box 60,60,60 --steps 200000 --runs 600 "
      "-o some.jsonl");
  CHECK(again.exit_code == 0);
  CHECK(place.shell("wc -l < some.jsonl").out == "600\n");
}

TEST_CASE("a run of an ensemble can be run alone") {
  const Workplace place;
  REQUIRE(place.shell("stigc explore sets/corner.yaml --runs 6 -o runs.jsonl").exit_code == 0);
  const auto alone =
      nlohmann::json::parse(place.shell("stigc explore sets/corner.yaml --run 4 --json").out);
  const auto one = nlohmann::json::parse(place.shell("sed -n 5p runs.jsonl").out);
  CHECK(one["run"] == 4);
  for (const char* key : {"run", "seed", "steps", "deposits", "structure_hash", "measures"}) {
    CHECK(alone[key] == one[key]);
  }
  CHECK(one.contains("stigc"));
  CHECK(one.contains("ruleset_hash"));
  CHECK(one.contains("max_steps"));
  CHECK(place.shell("stigc explore sets/corner.yaml --run 4 --runs 6").exit_code == 2);
  CHECK(place.shell("stigc explore sets/corner.yaml -o one.jsonl").exit_code == 2);
}

TEST_CASE("a journal of other work is not gone on with, and more runs may be asked for") {
  const Workplace place;
  place.shell("timeout -s KILL 0.2 " + std::string(STIGC_PROGRAM) + kEnsemble.substr(5) +
              "--threads 1 -o some.jsonl");
  if (!std::filesystem::exists(place.path("some.jsonl.journal"))) return;
  const Outcome other = place.shell(kEnsemble + "--seed 2 -o some.jsonl");
  CHECK(other.exit_code == 3);
  CHECK(other.err.find("is of another command") != std::string::npos);
  CHECK(place.shell(kEnsemble + "--runs 61 -o some.jsonl").exit_code == 2);  // given twice
  place.write("some.csv.journal", "mine\n");
  const Outcome mine = place.shell(kEnsemble + "-o some.csv");
  CHECK(mine.exit_code == 3);
  CHECK(mine.err.find("is there already, and no journal") != std::string::npos);
}

}  // namespace
}  // namespace stig
