// SPDX-License-Identifier: MIT
// Plans as files.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "search/objectives.h"
#include "search/plan_reader.h"
#include "search/uses.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
using namespace search;
namespace {

constexpr const char* kLeast =
    "stigc_search: 1\nname: a\nmethod: random\nscore: [{objective: bricks}]\n";

std::optional<SearchPlan> read(const std::string& text, std::string* said = nullptr) {
  Diagnostics diagnostics;
  auto plan = read_search_plan(std::make_shared<SourceFile>("plan.yaml", text), diagnostics);
  if (said != nullptr) *said = to_text(diagnostics);
  return plan;
}

}  // namespace

TEST_CASE("the least plan has the defaults, and each key changes its member") {
  const auto least = read(kLeast);
  REQUIRE(least.has_value());
  const SearchPlan defaults;
  CHECK(least->evaluations == defaults.evaluations);
  CHECK(least->batch == defaults.batch);
  CHECK(least->population == defaults.population);
  CHECK(least->screen.side == 20);
  CHECK_FALSE(least->draw.symmetry);
  const std::uint64_t hash = plan_hash(*least);
  for (const char* key :
       {"batch: 3", "population: 3", "seed: 9", "lattice: hexagonal", "floor: true", "colours: 4",
        "rules: 3", "wildcards: 0.5", "heights: 0.5", "symmetry: none", "symmetry: rotations",
        "symmetry: rotations+mirrors", "box: 5", "deposits: 9", "orders: 2",
        "axes: [{objective: bricks, from: 0, to: 1}, {objective: height, from: 0, to: 9, bins: "
        "3}]"}) {
    CAPTURE(key);
    const auto plan = read(kLeast + std::string(key) + "\n");
    REQUIRE(plan.has_value());
    CHECK(plan_hash(*plan) != hash);
  }
  CHECK(plan_hash(*read(kLeast + std::string("symmetry: any\n"))) == hash);
  const auto longer = read(kLeast + std::string("evaluations: 77\n"));
  CHECK(longer->evaluations == 77);
  CHECK(plan_hash(*longer) == hash);  // goes on from the same file
}

TEST_CASE("a plan names files, whose contents count") {
  auto plan = read(
      "stigc_search: 1\nname: a\nmethod: random\nscore: taste.lua\nproof: 9\n"
      "robot: bebot.yaml\n");
  REQUIRE(plan.has_value());
  CHECK(plan->score_program == "taste.lua");
  CHECK(plan->robot == "bebot.yaml");
  CHECK(plan->score.empty());
  const std::uint64_t hash = plan_hash(*plan);
  plan->outside = 5;
  CHECK(plan_hash(*plan) != hash);
}

TEST_CASE("what is wrong with a plan is said with its code") {
  std::string said;
  const auto refused = [&](const std::string& text, const char* code) {
    CHECK_FALSE(read(text, &said));
    CHECK_MESSAGE(said.find(code) != std::string::npos, said);
  };
  refused(kLeast + std::string("colors: 3\n"), "R101");
  refused("stigc_search: 1\nname: a\nmethod: random\n", "R102");
  refused("stigc_search: 1\nname: a\nmethod: map-elites\nscore: [{objective: bricks}]\n", "R102");
  refused(kLeast + std::string("colours: 16\n"), "R105");
  refused(kLeast + std::string("axes: [{objective: bricks, from: 1, to: 1}, "
                               "{objective: height, from: 0, to: 1}]\n"),
          "R105");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: [{objective: beauty}]\n", "R104");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: [{objective: distance}]\n", "R102");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: [{objective: robots}]\n", "R102");
  refused(kLeast + std::string("robot: bebot.yaml\n"), "R102");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: taste.txt\n", "R103");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: []\n", "R107");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: {objective: bricks}\n", "R103");
  refused("stigc_search: 1\nname: a\nmethod: random\nscore: [3, {objective: bricks, x: 1}]\n",
          "R101");
  refused(kLeast + std::string("target: \". .\"\n"), "R105");
  refused(kLeast + std::string("target: \"1 ?\"\n"), "the target's drawing");
}

TEST_CASE("plans that ship are sound, and the schema knows their keys") {
  const auto schema = nlohmann::json::parse(plan_schema());
  int plans = 0;
  for (const auto& entry : std::filesystem::directory_iterator(STIG_SOURCE_DIR "/plans")) {
    CAPTURE(entry.path().string());
    Diagnostics diagnostics;
    CHECK(read_search_plan_file(entry.path().string(), diagnostics).has_value());
    CHECK(to_text(diagnostics) == "");
    ++plans;
  }
  CHECK(plans >= 2);
  const std::string page = project_file("docs/search.md");
  for (const auto& [key, value] : schema.at("properties").items()) {
    CAPTURE(key);
    CHECK(page.find("| `" + key + "` |") != std::string::npos);
  }
}

}  // namespace stig
