// SPDX-License-Identifier: MIT
#include "search/search_plan.h"

#include <bit>

#include "base/hash.h"
#include "lattice/structure.h"
#include "search/objectives.h"

namespace stig::search {
namespace {

class Sum {
 public:
  void add(std::uint64_t value) { sum_ = combine(sum_, value); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(int value) { add(static_cast<std::uint64_t>(value)); }
  /// By name: numbers of objectives may change from version to version.
  void add_objective(std::size_t number) { add(hash_text(objectives()[number].name)); }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = hash_text("search plan 1");
};

}  // namespace

std::string_view to_string(SearchMethod method) {
  switch (method) {
    case SearchMethod::local:
      return "local";
    case SearchMethod::genetic:
      return "genetic";
    case SearchMethod::map_elites:
      return "map-elites";
    case SearchMethod::random:
      break;
  }
  return "random";
}

std::uint64_t plan_hash(const SearchPlan& plan) {
  Sum sum;
  sum.add(static_cast<int>(plan.draw.lattice));
  sum.add(static_cast<int>(plan.draw.floor));
  sum.add(plan.draw.colours);
  sum.add(plan.draw.rules);
  sum.add(plan.draw.wildcards);
  sum.add(plan.draw.heights);
  sum.add(plan.draw.symmetry ? static_cast<int>(*plan.draw.symmetry) : 3);
  sum.add(plan.screen.side);
  sum.add(plan.screen.most_deposits);
  sum.add(plan.orders);
  sum.add(plan.faults);
  sum.add(plan.proof);
  for (const Cell cell : plan.target) sum.add(placement_hash(cell, 1));
  sum.add(plan.seed);
  sum.add(static_cast<int>(plan.method));
  sum.add(plan.batch);
  sum.add(plan.population);
  for (const ScoreTerm& term : plan.score) {
    sum.add_objective(term.objective);
    sum.add(term.weight);
  }
  if (plan.outside != 0) sum.add(plan.outside);
  for (const GridAxis& axis : plan.axes) {
    sum.add_objective(axis.objective);
    sum.add(axis.from);
    sum.add(axis.to);
    sum.add(axis.bins);
  }
  return sum.value();
}

}  // namespace stig::search
