// SPDX-License-Identifier: MIT
// Architecture 4(c), the published hexagonal set. Figures were computed
// independently beforehand.
#include <doctest/doctest.h>

#include <set>

#include "rules/rule_table.h"
#include "support/oracle.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {
namespace {

std::size_t distinct_patterns(const RuleSet& rules) {
  const RuleTable table(rules);
  std::set<std::pair<std::vector<std::uint64_t>, Colour>> distinct;
  for (const Entry& entry : table.entries()) {
    std::vector<std::uint64_t> bits;
    for (const StateSet& s : entry.pattern.allowed) bits.push_back(s.bits());
    distinct.insert({bits, table.place(entry.source.rule)});
  }
  return distinct.size();
}

TEST_CASE("T4: 26 patterns turned, 28 upside down as well") {
  RuleSet rules = shipped("architecture-4c");
  CHECK(distinct_patterns(rules) == 28);
  rules.inversion = false;
  CHECK(distinct_patterns(rules) == 26);
}

TEST_CASE("T4: 73 deposits, the same ones for each of many orders") {
  const RuleSet rules = shipped("architecture-4c");
  const Box box = lay_box(*rules.box, rules.start, rules.floor);
  std::set<BrickMap> ends;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    ends.insert(build_in_some_order(rules, start_of(rules), 1, seed, box));
  }
  REQUIRE(ends.size() == 1);
  CHECK(ends.begin()->size() - rules.start.size() == 73);
}

// All orders at once are too many to follow (the rings are independent of each
// other), but a mast short enough for two rings is not.
TEST_CASE("T4: in a box of five levels every order ends alike") {
  const RuleSet rules = shipped("architecture-4c");
  Box box = lay_box(*rules.box, rules.start, rules.floor);
  box.low.z = 15;
  box.size.z = 5;
  const Exploration found = explore_orders(rules, start_of(rules), 1, box);
  REQUIRE(found.complete);
  REQUIRE(found.ends.size() == 1);
  CHECK(found.ends[0].size() == 5 + 6);
}

}  // namespace
}  // namespace stig
