// SPDX-License-Identifier: MIT
// The compiler's claims against a robot at lattice level that knows nothing of the policy, and
// against somebody who knows everything.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "compiler/lattice_walk.h"
#include "support/uses.h"

namespace stig {
namespace {

/// Can somebody who knows everything, and reaches what the robot reaches, complete it?
bool completable(const RuleSet& rules, const TargetStates& target,
                 const std::vector<ApproachSide>& sides) {
  const Abilities robot = paper_robot();
  const RuleTable table(rules);
  std::set<Bricks> seen;
  std::vector<Bricks> todo = {{rules.start.begin(), rules.start.end()}};
  while (!todo.empty()) {
    const Bricks bricks = todo.back();
    todo.pop_back();
    if (bricks.size() == target.bricks()) return true;
    if (!seen.insert(bricks).second) continue;
    BrickSet state(target.bricks());
    for (const PlacedBrick& brick : bricks) state.add(target.brick_at(brick.at));
    const LatticeWorld world(table, {bricks.begin(), bricks.end()}, std::nullopt);
    for (const Cell site : world.enabled_sites()) {
      const auto from = [&](ApproachSide side) {
        return reach(target, state, site, side, robot).obstruction == Obstruction::none;
      };
      if (std::none_of(sides.begin(), sides.end(), from)) continue;
      Bricks more = bricks;
      more.insert({site, target.colour(target.brick_at(site))});
      todo.push_back(std::move(more));
    }
  }
  return false;
}

TEST_CASE("out of reach is what nobody could complete") {
  int refused = 0;
  for (const char* name : {"P706-orientation", "P707-ambiguous", "P708-hidden", "P709-unsupported",
                           "P710-walled", "P711-deadlock"}) {
    CAPTURE(name);
    const RuleSet rules =
        rule_set(STIG_TESTS_DIR "/compiler/refused/" + std::string(name) + ".yaml");
    Diagnostics diagnostics;
    const CompiledRules compiled = compile_rules(rules, paper_robot(), {}, diagnostics);
    REQUIRE(compiled.target);
    CHECK(compiled.policy.out_of_reach == !completable(rules, *compiled.target, compiled.sides));
    refused += compiled.policy.out_of_reach ? 1 : 0;
  }
  CHECK(refused == 3);
}

TEST_CASE("whatever the order, decisions lead to the whole structure") {
  check_completes(shipped("staircase"));
  check_completes(rule_set(STIG_TESTS_DIR "/compiler/line.yaml"));
  check_completes(rule_set(STIG_TESTS_DIR "/compiler/column.yaml"));
  check_completes(shipped("stepped-pyramid"));
  check_completes(rule_set(STIG_TESTS_DIR "/compiler/plate.yaml"));
}

TEST_CASE("a wall and a U, from one side and from two that look alike") {
  RuleSet wall = rule_set(STIG_TESTS_DIR "/compiler/wall.yaml");
  RuleSet u = rule_set(STIG_TESTS_DIR "/compiler/u.yaml");
  check_completes(wall);
  check_completes(u);
  wall.physical->sides = {"+x", "-x"};
  check_completes(wall);
  wall.physical->sides = u.physical->sides = {"+y"};
  // Of the four columns any may be the first to be raised, but one alone.
  check_completes(wall);
  check_completes(u);
}

}  // namespace
}  // namespace stig
