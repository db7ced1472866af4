// SPDX-License-Identifier: MIT
// The compiler's claim against a robot at lattice level that knows nothing of the policy: it
// is put before every column from every side, asks the decision tree, and places what it is
// told. Every structure that this can lead to is walked.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "support.h"

namespace stig {
namespace {

using Bricks = std::set<PlacedBrick>;

std::optional<Colour> at(const Bricks& bricks, Cell cell) {
  for (const PlacedBrick& brick : bricks) {
    if (brick.at == cell) return brick.brick;
  }
  return std::nullopt;
}

/// Rows (v) and their foremost columns, before which a robot could stand.
std::set<std::pair<int, int>> columns(const Bricks& bricks, ApproachSide side) {
  std::map<int, int> foremost;
  for (const PlacedBrick& brick : bricks) {
    const SideCell c = seen_from(side, brick.at);
    const auto [row, added] = foremost.emplace(c.v, c.u);
    if (!added && row->second < c.u) row->second = c.u;
  }
  std::set<std::pair<int, int>> out;
  for (const auto& [v, u] : foremost) {
    bool free = true;
    for (const auto& [other, far] : foremost) {
      if (std::abs(other - v) <= 1 && far >= u + 2) free = false;
    }
    if (free) out.emplace(u, v);
  }
  return out;
}

struct Walk {
  const RuleSet& rules;
  const CompiledRules& compiled;
  Abilities robot = paper_robot();
  Sight sight{*compiled.target, robot};
  RuleTable table{rules};
  std::set<Bricks> seen = {};
  std::set<Bricks> ends = {};

  BrickSet as_set(const Bricks& bricks) const {
    BrickSet out(compiled.target->bricks());
    for (const PlacedBrick& brick : bricks) out.add(compiled.target->brick_at(brick.at));
    return out;
  }

  void walk(const Bricks& bricks) {
    if (!seen.insert(bricks).second) return;
    bool moved = false;
    for (const ApproachSide side : compiled.sides) {
      for (const auto& [u, v] : columns(bricks, side)) {
        Observation seen_here = sight.look(as_set(bricks), side, u, v);
        seen_here.side = side;
        const auto placement = decide(*compiled.decision, seen_here);
        if (!placement) continue;
        moved = true;
        walk(placed(bricks, side, u, v, *placement));
      }
    }
    if (!moved) ends.insert(bricks);
  }

  /// Holds the placement to the rules themselves, by the rule table on the bricks as they are.
  Bricks placed(Bricks bricks, ApproachSide side, int u, int v, const Placement& placement) {
    SideCell site{u + placement.at.du, v + placement.at.dv, placement.at.z};
    if (kind_of(placement) == PlacementKind::raise) {
      while (at(bricks, cell_from(side, site))) ++site.z;
    }
    const Cell cell = cell_from(side, site);
    REQUIRE(!at(bricks, cell));
    const LatticeWorld world(table, {bricks.begin(), bricks.end()}, std::nullopt);
    std::vector<Match> matches;
    table.matches(world.view(cell), cell.z, 1, matches);
    bool right = false;
    for (const Match& match : matches) right = right || table.place(match.rule) == placement.colour;
    REQUIRE(right);
    REQUIRE(reach(*compiled.target, as_set(bricks), cell, side, robot).obstruction ==
            Obstruction::none);
    bricks.insert({cell, placement.colour});
    return bricks;
  }
};

void check_completes(const RuleSet& rules) {
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(rules, paper_robot(), {}, diagnostics);
  REQUIRE(compiled.decision);
  Walk walk{rules, compiled};
  walk.walk({rules.start.begin(), rules.start.end()});
  REQUIRE(walk.ends.size() == 1);
  CHECK(walk.ends.begin()->size() == compiled.target->bricks());
}

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
