// SPDX-License-Identifier: MIT
// The staircase and the stepped pyramid: one rule set and a symmetry (T10), and what
// exact patterns can do (T5, T6). Figures were computed independently beforehand.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "support/exact_sets.h"
#include "support/oracle.h"
#include "support/shipped.h"
#include "support/uses.h"

namespace stig {
namespace {

BrickMap drawn(const RuleSet& rules) {
  REQUIRE(rules.expect.has_value());
  BrickMap bricks;
  for (const PlacedBrick& b : rules.expect->structure) bricks[b.at] = b.brick;
  return bricks;
}

/// Translated so that the lowest coordinates are 0.
BrickMap at_origin(const BrickMap& bricks) {
  Cell low = bricks.begin()->first;
  for (const auto& [c, colour] : bricks) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
  }
  BrickMap moved;
  for (const auto& [c, colour] : bricks) moved[Cell{} + (c - low)] = colour;
  return moved;
}

void check_every_order(const std::string& name, std::size_t states, std::size_t bricks) {
  CAPTURE(name);
  const RuleSet rules = shipped(name);
  const Exploration found = explore_orders(rules, start_of(rules));
  REQUIRE(found.complete);
  CHECK(found.states == states);
  REQUIRE(found.ends.size() == 1);
  CHECK(found.ends[0].size() == bricks);
  CHECK(at_origin(found.ends[0]) == at_origin(drawn(rules)));
}

TEST_CASE("T10: four short rules, 9 structures in one orientation and 513 in four") {
  check_every_order("staircase", 9, 6);
  check_every_order("stepped-pyramid", 513, 15);
}

TEST_CASE("T10: the two demonstrations differ in their symmetry alone") {
  const RuleSet one = shipped("staircase");
  RuleSet four = shipped("stepped-pyramid");
  CHECK(one.symmetry == Symmetry::none);
  CHECK(four.symmetry == Symmetry::rotations);
  four.symmetry = one.symmetry;
  four.name = one.name;
  four.title = one.title;
  four.expect = one.expect;
  four.physical = one.physical;
  CHECK(four == one);
}

TEST_CASE("the exact sets build the same staircase and pyramid") {
  check_every_order("staircase-exact", 7, 6);
  check_every_order("stepped-pyramid-exact", 163, 15);
  CHECK(drawn(shipped("staircase-exact")) == drawn(shipped("staircase")));
  CHECK(drawn(shipped("stepped-pyramid-exact")) == drawn(shipped("stepped-pyramid")));
}

TEST_CASE("T5: 130 of 720 orders give a coordinated staircase, the smallest with 4 rules") {
  const BrickMap target = drawn(shipped("staircase"));
  std::vector<Cell> order;
  for (const auto& [cell, colour] : target) order.push_back(cell);
  int choices = 0, coordinated = 0;
  std::size_t fewest = 100, fewest_from_foot = 100;
  do {
    ++choices;
    std::vector<std::vector<Cell>> orbits;
    for (const Cell cell : order) orbits.push_back({cell});
    const RuleSet rules = exact_set(target, orbits, Symmetry::none);
    if (!builds_exactly(rules, target)) continue;
    ++coordinated;
    fewest = std::min(fewest, rules.rules.size());
    if (order[0] == Cell{0, 0, 0}) {
      fewest_from_foot = std::min(fewest_from_foot, rules.rules.size());
    }
  } while (std::next_permutation(order.begin(), order.end()));
  CHECK(choices == 720);
  CHECK(coordinated == 130);
  CHECK(fewest == 4);
  CHECK(fewest_from_foot == shipped("staircase-exact").rules.size());
}

TEST_CASE("T6: 6 of 120 orders of orbits give the pyramid, the best with 10 rules") {
  const RuleSet best = shipped("stepped-pyramid-exact");
  BrickMap target;
  for (const auto& [cell, colour] : drawn(best)) target[cell - Offset{2, 2, 0}] = colour;
  std::vector<std::vector<Cell>> orbits = orbits_of(target, Symmetry::rotations);
  const std::vector<Cell> foot{{0, 0, 0}};
  std::erase(orbits, foot);
  std::sort(orbits.begin(), orbits.end());
  int choices = 0, coordinated = 0;
  std::size_t fewest = 100, fewest_entries = 1000;
  do {
    ++choices;
    std::vector<std::vector<Cell>> order{foot};
    order.insert(order.end(), orbits.begin(), orbits.end());
    const RuleSet rules = exact_set(target, order, Symmetry::rotations);
    if (!builds_exactly(rules, target)) continue;
    ++coordinated;
    fewest = std::min(fewest, rules.rules.size());
    fewest_entries = std::min(fewest_entries, RuleTable(rules).entries().size());
  } while (std::next_permutation(orbits.begin(), orbits.end()));
  CHECK(choices == 120);
  CHECK(coordinated == 6);
  CHECK(fewest == 10);
  CHECK(fewest_entries == 37);
  CHECK(best.rules.size() == fewest);
  CHECK(RuleTable(best).entries().size() == fewest_entries);
}

}  // namespace
}  // namespace stig
