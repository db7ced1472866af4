// SPDX-License-Identifier: MIT
// Small searches of every method.
#pragma once

#include "search/objectives.h"
#include "search/search_run.h"
#include "search/uses.h"
#include "support/uses.h"

namespace stig {
using namespace search;

inline SearchPlan small_plan(SearchMethod method) {
  SearchPlan plan;
  plan.name = "small";
  plan.draw.rules = 8;
  plan.screen = {10, 60};
  plan.method = method;
  plan.batch = 40;
  plan.population = 10;
  plan.evaluations = 200;
  plan.orders = 1;
  plan.score = {{*objective_number("compactness"), 1}, {*objective_number("rules_used"), 0.5}};
  plan.axes = {{*objective_number("bricks"), 0, 60, 6}, {*objective_number("symmetry"), 0, 16, 4}};
  return plan;
}

inline constexpr SearchMethod kMethods[] = {SearchMethod::random, SearchMethod::local,
                                            SearchMethod::genetic, SearchMethod::map_elites};

inline SearchState searched(const SearchPlan& plan, int threads) {
  SearchState state(plan);
  while (state.evaluated < evaluations_of(plan)) run_batch(plan, state, threads);
  return state;
}

}  // namespace stig
