// SPDX-License-Identifier: MIT
#include "assembly/oracle.h"
#include "support/uses.h"

#include <set>
#include <vector>

namespace stig {

namespace {

/// Is there a brick beside or below, so that a robot before a column would put it there?
bool next_to_something(const TargetBricks& target, const BrickSet& state, Cell cell) {
  for (const Offset step : {Offset{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, -1}}) {
    if (target.filled(state, cell + step)) return true;
  }
  return false;
}

bool can_be_put(const TargetBricks& target, const BrickSet& state, std::size_t brick,
                const Builders& builders) {
  const Cell cell = target.cell(brick);
  if (state.has(brick) || !next_to_something(target, state, cell)) return false;
  for (const ApproachSide side : builders.sides) {
    if (reach(target, state, cell, side, builders.robot).obstruction == Obstruction::none) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<bool> can_be_built(const TargetBricks& target, const Builders& builders,
                                 std::size_t most) {
  std::set<BrickSet> known;
  std::vector<BrickSet> open;
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    if (target.cell(i).z != target.floor_level()) continue;
    BrickSet start(target.bricks());
    start.add(i);
    known.insert(start);
    open.push_back(start);
  }
  while (!open.empty()) {
    const BrickSet state = open.back();
    open.pop_back();
    if (target.complete(state)) return true;
    if (known.size() > most) return std::nullopt;
    for (std::size_t i = 0; i < target.bricks(); ++i) {
      if (!can_be_put(target, state, i, builders)) continue;
      BrickSet next = state;
      next.add(i);
      if (known.insert(next).second) open.push_back(next);
    }
  }
  return false;
}

}  // namespace stig
