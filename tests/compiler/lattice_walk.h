// SPDX-License-Identifier: MIT
// A robot at lattice level that knows nothing of the policy: it is put before every column from
// every side, asks the decision tree, and places what it is told, each placement held to the rules
// and to reach. Every structure that this can lead to is walked.
#pragma once

#include <algorithm>
#include <map>
#include <set>

#include "compiler/support.h"
#include "support/uses.h"

namespace stig {

using Bricks = std::set<PlacedBrick>;

inline std::optional<Colour> at(const Bricks& bricks, Cell cell) {
  for (const PlacedBrick& brick : bricks) {
    if (brick.at == cell) return brick.brick;
  }
  return std::nullopt;
}

/// Rows (v) and their foremost columns, before which a robot could stand.
inline std::set<std::pair<int, int>> columns(const Bricks& bricks, ApproachSide side) {
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

struct LatticeWalk {
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

inline void check_completes(const RuleSet& rules) {
  Diagnostics diagnostics;
  const CompiledRules compiled = compile_rules(rules, paper_robot(), {}, diagnostics);
  REQUIRE(compiled.decision);
  LatticeWalk walk{rules, compiled};
  walk.walk({rules.start.begin(), rules.start.end()});
  REQUIRE(walk.ends.size() == 1);
  CHECK(walk.ends.begin()->size() == compiled.target->bricks());
}

}  // namespace stig
