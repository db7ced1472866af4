// SPDX-License-Identifier: MIT
#include "rules/explain.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "rules/rule_table.h"
#include "support/oracle.h"
#include "support/random_rules.h"
#include "support/uses.h"

namespace stig {
namespace {

/// Number of cells of a rule that disagree when it is turned by `turn`.
std::size_t disagreeing(const RuleSet& rules, const Rule& rule, const Orientation& turn,
                        const View& view) {
  const int size = neighbourhood(rules.lattice).size;
  const Pattern pattern = oriented(rule.pattern, turn, size);
  std::size_t number = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    if (!pattern.allowed[i].contains(view.at[i])) ++number;
  }
  return number;
}

TEST_CASE("what fires is what the oracle matches, in the same orientation") {
  CHECK(rc::check("explain == oracle", [] {
    const RuleSet rules = random_rule_set();
    const View view = random_view(rules);
    const auto z = static_cast<std::int32_t>(*rc::gen::inRange(-3, 6));
    const int stage = *rc::gen::inRange(1, rules.stage_count() + 1);
    std::vector<Match> firing;
    for (const RuleExplanation& said : explain(rules, view, z, stage).rules) {
      RC_ASSERT(said.fires == (said.cells.empty() && said.conditions.empty()));
      if (said.fires) firing.push_back({said.rule, said.orientation});
    }
    RC_ASSERT(firing == OracleMatcher(rules).matches(view, z, stage));
  }));
}

TEST_CASE("no orientation has fewer disagreeing cells than the one reported") {
  CHECK(rc::check("nearest", [] {
    const RuleSet rules = random_rule_set();
    const View view = random_view(rules);
    for (const RuleExplanation& said : explain(rules, view, 0, 1).rules) {
      const Rule& rule = rules.rules[said.rule];
      const auto turns =
          orientations(rules.lattice, rules.symmetry_of(rule), rules.inversion_of(rule));
      RC_ASSERT(said.orientations == turns.size());
      RC_ASSERT(disagreeing(rules, rule, turns[said.orientation], view) == said.cells.size());
      for (const Orientation& turn : turns) {
        RC_ASSERT(disagreeing(rules, rule, turn, view) >= said.cells.size());
      }
    }
  }));
}

/// One rule on the cubic lattice: a brick 1 to the west.
RuleSet west_rule() {
  RuleSet rules;
  rules.bricks.resize(2);
  Rule rule;
  rule.place = 2;
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  rule.pattern.allowed[static_cast<std::size_t>(n.index_of({-1, 0, 0}))] = StateSet::of(1);
  rules.rules.push_back(rule);
  return rules;
}

TEST_CASE("a failed cell says where, what was wanted and what is there") {
  const RuleExplanation said = explain(west_rule(), View{}, 0, 1).rules.at(0);
  REQUIRE(said.cells.size() == 1);
  CHECK(said.cells[0] == FailedCell{{-1, 0, 0}, StateSet::of(1), kEmpty});
}

TEST_CASE("every condition that fails is said at once") {
  RuleSet rules = west_rule();
  Rule& rule = rules.rules[0];
  rule.stage = 2;
  rule.height_min = 1;
  rule.height_max = 3;
  rule.counts.push_back({StateSet::of(1), true, 1, 2, {}});
  const RuleExplanation said = explain(rules, View{}, 5, 1).rules.at(0);
  const std::vector<FailedCondition> expected = {
      {"stage", 0, 1, 2, 2}, {"height", 0, 5, 1, 3}, {"count", 0, 0, 1, 2}};
  CHECK(said.conditions == expected);
  CHECK_FALSE(said.fires);
}

}  // namespace
}  // namespace stig
