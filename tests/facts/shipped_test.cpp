// SPDX-License-Identifier: MIT
// What every shipped rule set says of itself, held to the oracle's exploration: all
// orders of events where they can be followed, two that differ where they cannot.
#include <doctest/doctest.h>

#include "lattice/swarm.h"
#include "rules/rule_printer.h"
#include "support/oracle.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {
namespace {

std::optional<Box> box_of(const RuleSet& rules) {
  if (!rules.box) return std::nullopt;
  return lay_box(*rules.box, rules.start, rules.floor);
}

Structure built(const RuleSet& rules, std::uint64_t seed) {
  SwarmConfig config;
  config.motion = Motion::event;
  config.seed = seed;
  config.box = box_of(rules);
  config.max_deposits = 20000;
  return run_swarm(RuleTable(rules), rules.start, config).structure;
}

void check_coordinated(const RuleSet& rules) {
  // Too many orders to follow: see architecture_4c_test.cpp.
  if (rules.name == "architecture-4c") return;
  const Exploration found = explore_orders(rules, start_of(rules), 1, box_of(rules));
  REQUIRE(found.complete);
  REQUIRE(found.ends.size() == 1);
  if (rules.expect->bricks) {
    CHECK(static_cast<std::int64_t>(found.ends[0].size()) == *rules.expect->bricks);
  }
  if (rules.expect->structure.empty()) return;
  std::vector<PlacedBrick> bricks;
  for (const auto& [cell, colour] : found.ends[0]) bricks.push_back({cell, colour});
  CHECK(to_origin(Structure(rules.lattice, bricks)) ==
        to_origin(Structure(rules.lattice, rules.expect->structure)));
}

void check_order_dependent(const RuleSet& rules) {
  const Structure first = built(rules, 1);
  bool differs = false;
  for (std::uint64_t seed = 2; seed <= 30 && !differs; ++seed) {
    differs = !(built(rules, seed) == first);
  }
  CHECK(differs);
}

void check_endless(const RuleSet& rules) {
  CHECK(built(rules, 1).size() == 20000 + rules.start.size());
}

TEST_CASE("every shipped rule set keeps the verdict it expects") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    REQUIRE(rules.expect.has_value());
    REQUIRE(rules.expect->verdict.has_value());
    switch (*rules.expect->verdict) {
      case Verdict::coordinated:
        check_coordinated(rules);
        break;
      case Verdict::order_dependent:
        check_order_dependent(rules);
        break;
      case Verdict::endless:
        check_endless(rules);
        break;
    }
  }
}

TEST_CASE("every shipped rule set introduces itself, in canonical form") {
  for (const std::string& name : shipped_names()) {
    CAPTURE(name);
    const RuleSet rules = shipped(name);
    CHECK(rules.name == name);
    CHECK(!rules.title.empty());
    CHECK(!rules.source.empty());
    CHECK(!rules.comments.empty());
    CHECK(print_rule_set(rules) == rules.file->text());
  }
}

TEST_CASE("order-dependent: the two ends that its comment tells of") {
  const RuleSet rules = shipped("order-dependent");
  const Exploration found = explore_orders(rules, start_of(rules));
  REQUIRE(found.ends.size() == 2);
  CHECK(found.ends[0].size() + found.ends[1].size() == 2 + 3);
}

TEST_CASE("tiling: in a box every order fills the level alike") {
  const RuleSet rules = shipped("tiling");
  const Box box{{-3, -3, -1}, {7, 7, 3}, false, false};
  const BrickMap first = build_in_some_order(rules, start_of(rules), 1, 1, box);
  CHECK(first.size() == 49);
  for (std::uint64_t seed = 2; seed <= 20; ++seed) {
    CHECK(build_in_some_order(rules, start_of(rules), 1, seed, box) == first);
  }
}

}  // namespace
}  // namespace stig
