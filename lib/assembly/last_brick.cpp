// SPDX-License-Identifier: MIT
#include "assembly/last_brick.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>

#include "assembly/faces.h"
#include "compiler/columns.h"

namespace stig::assembly {

namespace {

bool beside_a_column(const TargetBricks& target, const BrickSet& state, std::uint32_t brick,
                     ApproachSide side) {
  const SideCell site = seen_from(side, target.cell(brick));
  return std::any_of(kColumnsAbout.begin(), kColumnsAbout.end(), [&](const auto& column) {
    const int u = site.u + column.first, v = site.v + column.second;
    return next_to_column(target, state, side, u, v, brick).has_value() &&
           comes_to_column(target, state, side, u, v);
  });
}

/// Adds the bricks that make this result whatever else stands; false where there are none such.
bool add_obstacles(const TargetBricks& target, const ReachResult& result, Cell cell,
                   ApproachSide side, std::vector<std::uint32_t>& out) {
  const SideCell site = seen_from(side, cell);
  const auto add = [&](int du, int dv, int dz) {
    out.push_back(target.brick_at(cell_from(side, {site.u + du, site.v + dv, site.z + dz})));
  };
  switch (result.obstruction) {
    case Obstruction::body_blocked:
    case Obstruction::covered:
      out.push_back(target.brick_at(result.where));
      return true;
    case Obstruction::slot:
      add(0, -1, 0);
      add(0, 1, 0);
      return true;
    case Obstruction::effector_blocked: {
      // At the corners behind it is in the way only while nothing straight behind stops the robot.
      const SideCell where = seen_from(side, result.where);
      if (where.u != site.u && where.v != site.v) return false;
      out.push_back(target.brick_at(result.where));
      return true;
    }
    default:
      return false;
  }
}

}  // namespace

std::optional<ApproachSide> side_for(const TargetBricks& target, const BrickSet& state,
                                     std::uint32_t brick, const Builders& builders,
                                     std::vector<std::uint32_t>* obstacles) {
  assert(brick < target.bricks());
  bool known = obstacles != nullptr;
  for (const ApproachSide side : builders.sides) {
    const Cell cell = target.cell(brick);
    const ReachResult result = reach(target, state, cell, side, builders.robot);
    if (result.obstruction != Obstruction::none) {
      known = known && add_obstacles(target, result, cell, side, *obstacles);
    } else if (beside_a_column(target, state, brick, side)) {
      // What bars other sides is no reason to pass it over when it is asked for again.
      if (obstacles != nullptr) obstacles->clear();
      return side;
    } else {
      known = false;
    }
  }
  if (obstacles != nullptr && !known) obstacles->clear();
  return std::nullopt;
}

Connected::Connected(const TargetBricks& target) : target_(target) {
  whole_ = all_of(target.whole());
}

bool Connected::without(const BrickSet& left, std::uint32_t removed) {
  assert(!left.has(removed));
  return (whole_ && about(left, target_.cell(removed))) || all_of(left);
}

bool Connected::all_of(const BrickSet& left) {
  assert(left.count() > 0);
  std::uint32_t first = 0;
  while (!left.has(first)) ++first;
  BrickSet met(target_.bricks());
  met.add(first);
  edge_ = {first};
  while (!edge_.empty()) {
    const Cell cell = target_.cell(edge_.back());
    edge_.pop_back();
    for (const Offset step : kFaces) {
      const std::uint32_t brick = target_.brick_at(cell + step);
      if (brick == TargetBricks::kNone || !left.has(brick) || met.has(brick)) continue;
      met.add(brick);
      edge_.push_back(brick);
    }
  }
  return met == left;
}

/// Do the neighbours of an empty cell hang together by steps through the 26 about it? Then whatever
/// hung together through the cell still does.
bool Connected::about(const BrickSet& left, Cell middle) const {
  const auto place = [](Offset o) { return (o.z + 1) * 9 + (o.y + 1) * 3 + o.x + 1; };
  std::uint32_t faces = 0, met = 0;
  std::vector<Offset> edge;
  for (const Offset step : kFaces) {
    if (!target_.filled(left, middle + step)) continue;
    faces |= 1U << place(step);
    if (edge.empty()) edge.push_back(step);
  }
  if (edge.empty()) return false;
  met = 1U << place(edge.front());
  while (!edge.empty()) {
    const Offset from = edge.back();
    edge.pop_back();
    for (const Offset step : kFaces) {
      const Offset to = from + step;
      if (std::max({std::abs(to.x), std::abs(to.y), std::abs(to.z)}) > 1 || to == Offset{})
        continue;
      if ((met >> place(to) & 1U) != 0 || !target_.filled(left, middle + to)) continue;
      met |= 1U << place(to);
      edge.push_back(to);
    }
  }
  return (faces & ~met) == 0;
}

}  // namespace stig::assembly
