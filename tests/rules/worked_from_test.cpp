// SPDX-License-Identifier: MIT
#include "rules/worked_from.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "support/oracle.h"
#include "support/random_rules.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {
namespace {

TEST_CASE("nothing changes where there is nothing to leave out") {
  const RuleSet pyramid = shipped("stepped-pyramid");
  CHECK(worked_from(pyramid, {}) == pyramid);
  CHECK(worked_from(pyramid, {"-y", "+x", "-x", "+y"}) == pyramid);
  const RuleSet staircase = shipped("staircase");
  CHECK(worked_from(staircase, {"+y"}) == staircase);
}

TEST_CASE("rules in all turns, one by one, match where the symmetric rules do") {
  CHECK(rc::check("three sides and one are four", [] {
    RuleSet rules = random_rule_set();
    rules.lattice = Lattice::cubic;
    const View view = random_view(rules);
    for (std::size_t i = 0; i < rules.rules.size(); ++i) rules.rules[i].name = std::to_string(i);
    // A turned rule's name begins with the name that it had.
    const auto matching = [&](const RuleSet& set) {
      std::set<int> out;
      for (const Match& match : OracleMatcher(set).matches(view, 0, 1)) {
        out.insert(std::stoi(set.rules[match.rule].name));
      }
      return out;
    };
    std::set<int> together = matching(worked_from(rules, {"+x", "+y", "-y"}));
    together.merge(matching(worked_from(rules, {"-x"})));
    RC_ASSERT(together == matching(rules));
  }));
}

TEST_CASE("a rule as written is that of a robot at +x") {
  const RuleSet pyramid = shipped("stepped-pyramid");
  const RuleSet from_x = worked_from(pyramid, {"+x"}), from_y = worked_from(pyramid, {"+y"});
  REQUIRE(from_x.rules.size() == pyramid.rules.size());
  REQUIRE(from_y.rules.size() == pyramid.rules.size());
  const Neighbourhood& n = neighbourhood(Lattice::cubic);
  const auto at = [&](int x, int y, int z) {
    return static_cast<std::size_t>(n.index_of({x, y, z}));
  };
  const std::size_t middle = 1;  // "start the middle column": beside a 3
  CHECK(from_x.rules[middle].pattern == pyramid.rules[middle].pattern);
  CHECK(from_x.rules[middle].pattern.allowed[at(-1, 0, 0)] == StateSet::of(3));
  CHECK(from_y.rules[middle].pattern.allowed[at(0, -1, 0)] == StateSet::of(3));
  CHECK(from_y.rules[middle].pattern.allowed[at(-1, 0, 0)] == StateSet::anything());
  CHECK(from_x.symmetry == Symmetry::none);
}

}  // namespace
}  // namespace stig
