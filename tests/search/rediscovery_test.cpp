// SPDX-License-Identifier: MIT
// Rule sets for known shapes and for a new one, found from random starts as the shipped plans say,
// in fewer evaluations.
#include <doctest/doctest.h>

#include "search/objectives.h"
#include "search/plan_reader.h"
#include "search/search_run.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

using namespace search;

struct Best {
  double distance = 1, coordinated = 0;
  std::size_t bricks = 0;
};

Best best_of(const std::string& plan_file, std::uint64_t evaluations) {
  Diagnostics diagnostics;
  auto plan = read_search_plan(
      std::make_shared<const SourceFile>(plan_file, project_file(plan_file)), diagnostics);
  REQUIRE(plan.has_value());
  plan->evaluations = evaluations;
  SearchState state(*plan);
  while (state.evaluated < evaluations_of(*plan)) run_batch(*plan, state, 2);
  const Individual& best = state.archive.kept()[state.archive.best(1).front()];
  const auto value = [&](std::string_view name) { return best.values[*objective_number(name)]; };
  return {value("distance"), value("coordinated"), best.bricks.size()};
}

}  // namespace

TEST_CASE("a coordinated rule set for the 3×3 comb on a pedicel is found again") {
  const Best best = best_of("plans/comb.yaml", 3072);
  CHECK(best.distance == 0);
  CHECK(best.coordinated == 1);
  CHECK(best.bricks == 10);
}

TEST_CASE("a coordinated rule set for the staircase's shape is found again") {
  const Best best = best_of("plans/staircase-shape.yaml", 1280);
  CHECK(best.distance == 0);
  CHECK(best.coordinated == 1);
  CHECK(best.bricks == 6);
}

TEST_CASE("a coordinated rule set is found for a new shape, a cross with a tower on each arm") {
  const Best best = best_of("plans/towers.yaml", 2560);
  CHECK(best.distance == 0);
  CHECK(best.coordinated == 1);
  CHECK(best.bricks == 17);
}

}  // namespace stig
