// SPDX-License-Identifier: MIT
#include "lattice/event_orders.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "lattice/swarm.h"
#include "support/oracle.h"
#include "support/random_rules.h"
#include "support/shipped.h"
#include "support/small_sets.h"
#include "support/uses.h"

namespace stig {
namespace {

EventOrders orders_of(const RuleSet& rules, const EventOrdersLimits& limits = {}) {
  std::optional<Box> box;
  if (rules.box) box = lay_box(*rules.box, rules.start, rules.floor);
  return explore_event_orders(RuleTable(rules), rules.start, box, limits);
}

/// The first stages of a set.
RuleSet first_stages(RuleSet rules, int last) {
  std::erase_if(rules.rules, [&](const Rule& rule) { return rule.stage > last; });
  return rules;
}

TEST_CASE("two sites of one event each: four states, one end") {
  const RuleSet rules = small_set(east_of("1", "2") + east_of("2", "3"),
                                  "start:\n  - {at: [0, 0, 0], brick: 1}\n"
                                  "  - {at: [0, 5, 0], brick: 1}\n");
  const EventOrders orders = orders_of(rules);
  CHECK(orders.complete);
  CHECK(orders.states == 9);  // 0, 1 or 2 events on each line
  CHECK(orders.ends.size() == 1);
}

TEST_CASE("architecture 4(n): states and ends of its first five stages as computed elsewhere") {
  const EventOrders orders = orders_of(first_stages(shipped("architecture-4n"), 5));
  CHECK(orders.complete);
  CHECK(orders.states_by_stage == std::vector<std::uint64_t>{2, 48, 40, 1296, 160000});
  REQUIRE(orders.ends.size() == 1);
  CHECK(orders.ends[0].size() == 1 + 1 + 8 + 9 + 16 + 24);
}

TEST_CASE("under mirrors its second stage ends in seven ways") {
  RuleSet rules = first_stages(shipped("architecture-4n"), 2);
  rules.symmetry = Symmetry::rotations_mirrors;
  const EventOrders orders = orders_of(rules);
  std::multiset<std::size_t> sizes;
  for (const Structure& end : orders.ends) sizes.insert(end.size() - 2);
  CHECK(sizes == std::multiset<std::size_t>{6, 6, 7, 7, 7, 7, 8});
}

using Bricks = std::vector<PlacedBrick>;

RuleSet random_one_stage_set() {
  RuleSet rules = random_rule_set();
  for (Rule& rule : rules.rules) rule.stage = 0;
  rules.conflicts = Conflicts::random;  // the oracle knows no order among rules
  rules.start = {{{0, 0, 0}, 1}};
  return rules;
}

std::set<Bricks> ends_of(const EventOrders& orders) {
  std::set<Bricks> ends;
  for (const Structure& end : orders.ends) ends.insert(end.bricks());
  RC_ASSERT(ends.size() == orders.ends.size());
  return ends;
}

TEST_CASE("states and ends are the oracle's, in solid boxes") {
  CHECK(rc::check("solid", [] {
    const RuleSet rules = random_one_stage_set();
    const Box box{{-1, -1, 0}, {3, 2, 2}, false, rules.floor};
    ExplorationLimits limits;
    limits.states = 3000;
    const Exploration slow = explore_orders(rules, start_of(rules), 1, box, limits);
    if (!slow.complete) return;
    const EventOrders fast = explore_event_orders(RuleTable(rules), rules.start, box);
    RC_ASSERT(fast.complete);
    RC_ASSERT(fast.states == slow.states);
    std::set<Bricks> expected;
    for (const BrickMap& end : slow.ends) {
      Bricks bricks;
      for (const auto& [cell, colour] : end) bricks.push_back({cell, colour});
      expected.insert(bricks);
    }
    RC_ASSERT(ends_of(fast) == expected);
  }));
}

/// Every structure reached, looked at afresh each time: slow, and unlike the oracle
/// at home in periodic boxes. Empty when there are more than `most`.
std::set<Bricks> reached_slowly(const RuleSet& rules, const Box& box, std::size_t most,
                                std::set<Bricks>& ends) {
  const RuleTable table(rules);
  const OracleMatcher matcher(rules);
  std::set<Bricks> reached{rules.start};
  std::vector<Bricks> waiting{rules.start};
  while (!waiting.empty()) {
    const Bricks bricks = waiting.back();
    waiting.pop_back();
    const Structure structure(rules.lattice, bricks);
    const auto sites = enabled_sites(structure, table, box, 1);
    if (sites.empty()) ends.insert(bricks);
    for (const Cell site : sites) {
      for (const Match& match : matcher.matches(view_at(structure, table, box, site), site.z, 1)) {
        Structure next = structure;
        next.place(site, table.place(match.rule));
        if (reached.insert(next.bricks()).second) waiting.push_back(next.bricks());
      }
    }
    if (reached.size() > most) return {};
  }
  return reached;
}

TEST_CASE("periodic boxes so narrow that a cell is its own neighbour hold no surprise") {
  CHECK(rc::check("periodic", [] {
    const RuleSet rules = random_one_stage_set();
    const Offset size{*rc::gen::inRange(1, 4), *rc::gen::inRange(1, 3), *rc::gen::inRange(1, 3)};
    const Box box{{0, 0, 0}, size, true, rules.floor};
    std::set<Bricks> ends;
    const std::set<Bricks> reached = reached_slowly(rules, box, 500, ends);
    if (reached.empty()) return;
    const EventOrders fast = explore_event_orders(RuleTable(rules), rules.start, box);
    RC_ASSERT(fast.complete);
    RC_ASSERT(fast.states == reached.size());
    RC_ASSERT(ends_of(fast) == ends);
  }));
}

TEST_CASE("a stage's number of deposits ends it") {
  const std::string rules =
      east_of("1", "1", "    stage: 1\n") + east_of("1", "2", "    stage: 2\n");
  const EventOrders orders = orders_of(small_set(rules, "stages: {1: 3}\n"));
  CHECK(orders.complete);
  CHECK(orders.states_by_stage == std::vector<std::uint64_t>{4, 2});
  REQUIRE(orders.ends.size() == 1);
  CHECK(orders.ends[0].size() == 5);
}

TEST_CASE("where rules conflict, the first in the file acts, or by lot any") {
  const std::string rules = east_of("1", "2") + east_of("1", "3");
  CHECK(orders_of(small_set(rules, "conflicts: first\n")).ends.size() == 1);
  CHECK(orders_of(small_set(rules, "conflicts: random\n")).ends.size() == 2);
}

TEST_CASE("limits end the search, and it says so") {
  const RuleSet endless = small_set(east_of("1", "1"));
  EventOrdersLimits limits;
  limits.states = 100;
  const EventOrders few = orders_of(endless, limits);
  CHECK_FALSE(few.complete);
  CHECK(few.states == 100);
  CHECK(few.ends.empty());
  limits = {};
  limits.words_written = 100000;
  CHECK_FALSE(orders_of(endless, limits).complete);
  limits = {};
  limits.words_held = 1000;
  CHECK_FALSE(orders_of(endless, limits).complete);
  const std::atomic<bool> stop{true};
  CHECK_FALSE(explore_event_orders(RuleTable(endless), endless.start, std::nullopt, {}, {{}, &stop})
                  .complete);
}

TEST_CASE("a start without an event is its own end") {
  const EventOrders orders = orders_of(small_set(east_of("2", "3")));
  CHECK(orders.complete);
  CHECK(orders.states == 1);
  REQUIRE(orders.ends.size() == 1);
  CHECK(orders.ends[0].size() == 1);
}

}  // namespace
}  // namespace stig
