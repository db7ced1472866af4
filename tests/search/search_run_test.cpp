// SPDX-License-Identifier: MIT
// Searches: the same on any number of threads, and better than chance where they should be.
#include <doctest/doctest.h>

#include <set>

#include "search/plans.h"

namespace stig {
namespace {

double best_score(const SearchState& state) {
  return state.archive.kept()[state.archive.best(1).front()].score;
}

}  // namespace

TEST_CASE("two threads find what one does, by every method") {
  std::set<std::uint64_t> contents;
  for (const SearchMethod method : kMethods) {
    CAPTURE(to_string(method));
    const SearchPlan plan = small_plan(method);
    const SearchState one = searched(plan, 1), two = searched(plan, 2);
    CHECK(one.evaluated == 200);
    CHECK(one.archive.content_hash() == two.archive.content_hash());
    contents.insert(one.archive.content_hash());
  }
  CHECK(contents.size() == 4);  // methods differ, and so do their hashes
}

TEST_CASE("another seed is another search") {
  SearchPlan plan = small_plan(SearchMethod::random);
  const std::uint64_t before = searched(plan, 1).archive.content_hash();
  plan.seed = 2;
  CHECK(searched(plan, 1).archive.content_hash() != before);
}

TEST_CASE("methods that learn end above random search") {
  SearchPlan plan = small_plan(SearchMethod::random);
  plan.evaluations = 2000;
  plan.score = {{*objective_number("modules"), 1}, {*objective_number("rules_used"), 10}};
  const double chance = best_score(searched(plan, 2));
  plan.method = SearchMethod::genetic;
  CHECK(best_score(searched(plan, 2)) > chance);
  plan.method = SearchMethod::local;
  CHECK(best_score(searched(plan, 2)) > chance);
  plan.method = SearchMethod::map_elites;
  CHECK(best_score(searched(plan, 2)) > chance);
}

TEST_CASE("MAP-Elites fills more of its grid than random search") {
  SearchPlan plan = small_plan(SearchMethod::map_elites);
  plan.evaluations = 1200;
  const std::size_t filled = searched(plan, 2).archive.elites().size();
  plan.method = SearchMethod::random;
  CHECK(filled > searched(plan, 2).archive.elites().size());
  CHECK(filled <= 24);
}

TEST_CASE("children name their parents, and an evaluation can be done alone") {
  const SearchPlan plan = small_plan(SearchMethod::genetic);
  SearchState state(plan);
  run_batch(plan, state, 1);
  const FindArchive before = state.archive;
  const std::size_t kept = before.kept().size();
  run_batch(plan, state, 2);
  REQUIRE(state.archive.kept().size() > kept);
  Screener screener(plan.screen);
  for (std::size_t i = kept; i < state.archive.kept().size(); ++i) {
    const Individual& child = state.archive.kept()[i];
    const Individual again = evaluate(plan, plan_hash(plan), before, child.id, screener);
    CHECK(again.genome == child.genome);
    CHECK(again.bricks == child.bricks);
    CHECK(again.values == child.values);
    CHECK((child.origin == "drawn") == !child.parent);
    CHECK((child.origin == "crossed") == child.other_parent.has_value());
  }
}

TEST_CASE("robots are asked about what is proved alone, and all else is refused as not proved") {
  SearchPlan plan = small_plan(SearchMethod::random);
  plan.proof = 1'000'000;
  plan.draw.rules = 2;
  plan.batch = 100;
  plan.robot = "some.yaml";
  Judges judges;
  judges.compile = [](const Genome& genome) {
    return RobotWork{static_cast<int>(genome.rules.size()), 0};
  };
  SearchState state(plan);
  REQUIRE(run_batch(plan, state, 2, nullptr, judges));
  int asked = 0;
  for (const Individual& one : state.archive.kept()) {
    const bool coordinated = one.values[*objective_number("coordinated")] == 1;
    CHECK(one.values[*objective_number("robots")] == (coordinated ? plan.draw.rules : 0));
    CHECK(one.values[*objective_number("refusal")] == (coordinated ? 0 : kNotProved));
    asked += coordinated ? 1 : 0;
  }
  CHECK(asked > 0);
}

TEST_CASE("a score from outside takes the place of the sum, and one that is missing ends a batch") {
  const SearchPlan plan = small_plan(SearchMethod::genetic);
  Judges judges;
  judges.score = [](const Scored& one, std::string&) {
    return std::optional(static_cast<double>(one.bricks.size()) + one.values[0]);
  };
  SearchState state(plan);
  REQUIRE(run_batch(plan, state, 2, nullptr, judges));
  for (const Individual& one : state.archive.kept()) {
    CHECK(one.score == 2 * static_cast<double>(one.bricks.size()));
  }
  const std::uint64_t before = state.archive.content_hash();
  judges.score = [](const Scored& one, std::string& problem) {
    if (one.id >= 45) problem = "none";
    return one.id < 45 ? std::optional(1.0) : std::nullopt;
  };
  auto made = make_batch(plan, state, 40, 1);
  REQUIRE(measure_batch(plan, made, judges, 2));
  REQUIRE(first_unscored(made) != nullptr);
  CHECK(first_unscored(made)->id == 45);
  CHECK_FALSE(run_batch(plan, state, 2, nullptr, judges));
  CHECK(state.evaluated == 40);
  CHECK(state.archive.content_hash() == before);
}

TEST_CASE("a search that is stopped leaves the state as it was") {
  const SearchPlan plan = small_plan(SearchMethod::random);
  SearchState state(plan);
  const std::atomic<bool> stop = true;
  CHECK_FALSE(run_batch(plan, state, 1, &stop).has_value());
  CHECK(state.evaluated == 0);
  CHECK(state.archive.kept().empty());
}

}  // namespace stig
