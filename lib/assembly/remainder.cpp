// SPDX-License-Identifier: MIT
#include "assembly/remainder.h"

#include <cassert>

namespace stig::assembly {

namespace {

/// Holds are granted, see remainder.h: what is missing below or beside a brick bars nothing.
bool bars(const ReachResult& result) {
  return result.obstruction != Obstruction::none &&
         result.obstruction != Obstruction::unsupported &&
         result.obstruction != Obstruction::overhang;
}

/// What bars the brick among `others`, whatever holds it.
ReachResult barred_among(const TargetBricks& target, const BrickSet& others, std::uint32_t brick,
                         ApproachSide side, const Abilities& robot) {
  const ReachResult result = reach(target, others, target.cell(brick), side, robot);
  if (result.obstruction != Obstruction::effector_blocked) return result;
  // A brick behind the site would stop the end-effector sooner, and so may help. It may be one that
  // has been taken away; the proof grants it, as it grants holds.
  const SideCell site = seen_from(side, target.cell(brick));
  const std::uint32_t behind = target.brick_at(cell_from(side, {site.u - 1, site.v, site.z + 1}));
  if (behind == TargetBricks::kNone || others.has(behind)) return result;
  BrickSet with = others;
  with.add(behind);
  const ReachResult stopped = reach(target, with, target.cell(brick), side, robot);
  return bars(stopped) ? result : stopped;
}

/// From every side; fewer when it can be put from one.
std::vector<Bar> bars_of(const TargetBricks& target, const BrickSet& others, std::uint32_t brick,
                         const Builders& builders) {
  std::vector<Bar> out;
  for (const ApproachSide side : builders.sides) {
    const ReachResult why = barred_among(target, others, brick, side, builders.robot);
    // One side that is free is enough, and the list is of no use then.
    if (!bars(why)) break;
    out.push_back({side, why});
  }
  return out;
}

/// Takes away what can be taken away, in the order of the numbers and back; false when nothing can.
bool take_some(const TargetBricks& target, const Builders& builders,
               std::optional<std::uint32_t> start, BrickSet& left) {
  const auto count = static_cast<std::uint32_t>(target.bricks());
  bool some = false;
  for (std::uint32_t k = 0; k < 2 * count; ++k) {
    const std::uint32_t i = k < count ? k : 2 * count - 1 - k;
    if (!left.has(i) || start == i) continue;
    left.remove(i);
    const bool barred = bars_of(target, left, i, builders).size() == builders.sides.size();
    if (barred) left.add(i);
    some = some || !barred;
  }
  return some;
}

}  // namespace

Remainder find_remainder(const TargetBricks& target, const Builders& builders,
                         std::optional<std::uint32_t> start) {
  assert(!start || *start < target.bricks());
  Remainder out{target.whole(), {}};
  while (take_some(target, builders, start, out.bricks)) {
  }
  if (out.bricks.count() < 2) return {BrickSet{}, {}};
  for (std::uint32_t i = 0; i < target.bricks(); ++i) {
    if (!out.bricks.has(i) || start == i) continue;
    BrickSet others = out.bricks;
    others.remove(i);
    out.barred.push_back({i, bars_of(target, others, i, builders)});
  }
  return out;
}

}  // namespace stig::assembly
