// SPDX-License-Identifier: MIT
// Architecture 4(n), the published nine steps, followed through every order of
// events. Figures were computed independently beforehand.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "lattice/swarm.h"
#include "support/oracle.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {
namespace {

/// The one end of stages 1 … last, each run from the end of the one before.
BrickMap end_of_stages(const RuleSet& rules, int last) {
  BrickMap bricks = start_of(rules);
  for (int stage = 1; stage <= last; ++stage) {
    bricks = build_in_some_order(rules, bricks, stage, 1);
  }
  return bricks;
}

std::multiset<std::size_t> deposits_of(const Exploration& found, const BrickMap& start) {
  std::multiset<std::size_t> deposits;
  for (const BrickMap& end : found.ends) deposits.insert(end.size() - start.size());
  return deposits;
}

TEST_CASE("architecture 4(n): 66 rules in nine stages stand for 238 patterns") {
  const RuleSet rules = shipped("architecture-4n");
  REQUIRE(rules.rules.size() == 66);
  const std::array<int, 9> sizes{1, 8, 4, 13, 7, 8, 10, 10, 5};
  std::set<std::tuple<int, std::vector<std::uint64_t>, Colour>> patterns;
  const auto group = orientations(rules.lattice, rules.symmetry, rules.inversion);
  std::array<int, 9> counted{};
  for (const Rule& rule : rules.rules) {
    ++counted.at(static_cast<std::size_t>(rule.stage - 1));
    for (const Orientation& g : group) {
      std::vector<std::uint64_t> turned(26);
      for (std::size_t i = 0; i < 26; ++i) {
        turned[static_cast<std::size_t>(g.image[i])] = rule.pattern.allowed[i].bits();
      }
      patterns.insert({rule.stage, turned, rule.place});
    }
  }
  CHECK(counted == sizes);
  CHECK(patterns.size() == 238);
}

TEST_CASE("T3a: steps 1 to 5 each end in one structure, whatever the order") {
  const RuleSet rules = shipped("architecture-4n");
  const std::array<std::size_t, 5> deposits{1, 8, 9, 16, 24};
  const std::array<std::size_t, 5> states{2, 48, 40, 1296, 160000};
  BrickMap bricks = start_of(rules);
  for (std::size_t step = 0; step < deposits.size(); ++step) {
    CAPTURE(step + 1);
    const Exploration found = explore_orders(rules, bricks, static_cast<int>(step) + 1);
    REQUIRE(found.complete);
    CHECK(found.states == states[step]);
    REQUIRE(found.ends.size() == 1);
    CHECK(found.ends[0].size() - bricks.size() == deposits[step]);
    bricks = found.ends[0];
  }
}

TEST_CASE("T3b: step 6 is a race on each of four sides") {
  const RuleSet rules = shipped("architecture-4n");
  const BrickMap before = end_of_stages(rules, 5);
  const Exploration found = explore_orders(rules, before, 6);
  REQUIRE(found.complete);
  CHECK(found.states == 160000);
  CHECK(found.ends.size() == 16);
  // A side closes with 6 bricks or stalls with 5: binomial over the four sides.
  CHECK(deposits_of(found, before) ==
        std::multiset<std::size_t>{20, 21, 21, 21, 21, 22, 22, 22, 22, 22, 22, 23, 23, 23, 23, 24});
}

/// Deposits of step 7 alone in an unbounded world, from an end of step 6.
std::uint64_t deposits_of_step_7(const RuleSet& rules, const BrickMap& start) {
  RuleSet step = rules;
  std::erase_if(step.rules, [](const Rule& rule) { return rule.stage != 7; });
  for (Rule& rule : step.rules) rule.stage = 1;
  std::vector<PlacedBrick> bricks;
  for (const auto& [cell, colour] : start) bricks.push_back({cell, colour});
  SwarmConfig config;
  config.motion = Motion::event;
  config.max_deposits = 5000;
  return run_swarm(RuleTable(step), bricks, config).deposits;
}

TEST_CASE("step 7 has no end when all four sides closed, and one otherwise") {
  const RuleSet rules = shipped("architecture-4n");
  const BrickMap before = end_of_stages(rules, 5);
  bool closed = false, stalled = false;
  for (std::uint64_t seed = 1; seed <= 1000 && !(closed && stalled); ++seed) {
    const BrickMap end = build_in_some_order(rules, before, 6, seed);
    const bool all_closed = end.size() - before.size() == 24;
    if (all_closed ? closed : stalled) continue;
    (all_closed ? closed : stalled) = true;
    const std::uint64_t deposits = deposits_of_step_7(rules, end);
    CHECK((all_closed ? deposits == 5000 : deposits < 200));
  }
  CHECK(closed);
  CHECK(stalled);
}

TEST_CASE("T3c: mirrors undo the coordination of step 2") {
  RuleSet rules = shipped("architecture-4n");
  const BrickMap before = end_of_stages(rules, 1);
  rules.symmetry = Symmetry::rotations_mirrors;
  const Exploration found = explore_orders(rules, before, 2);
  REQUIRE(found.complete);
  CHECK(found.ends.size() == 7);
  const auto deposits = deposits_of(found, before);
  CHECK(*deposits.begin() == 6);
  CHECK(*deposits.rbegin() == 8);
}

TEST_CASE("T3d: all 66 rules at once are order-dependent") {
  RuleSet rules = shipped("architecture-4n");
  for (Rule& rule : rules.rules) rule.stage = 0;
  std::set<BrickMap> ends;
  for (std::uint64_t seed = 1; seed <= 20 && ends.size() < 2; ++seed) {
    ends.insert(build_in_some_order(rules, start_of(rules), 1, seed, std::nullopt, 400));
  }
  CHECK(ends.size() >= 2);
}

}  // namespace
}  // namespace stig
