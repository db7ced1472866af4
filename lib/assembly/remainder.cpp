// SPDX-License-Identifier: MIT
#include "assembly/remainder.h"

#include <algorithm>
#include <cassert>

#include "assembly/faces.h"
#include "assembly/holds.h"

namespace stig::assembly {

namespace {

/// What bears a brick is granted, see remainder.h: what is missing below or beside a brick bars
/// nothing.
bool bars(const ReachResult& result) {
  return result.obstruction != Obstruction::none && !is_unheld(result.obstruction);
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

/// How many bricks of a range are left, in logarithmic time (P. Fenwick 1994).
class Counts {
 public:
  explicit Counts(std::size_t size) : sums_(size + 1, 0) {
    for (std::size_t i = 1; i < sums_.size(); ++i) sums_[i] = static_cast<std::int32_t>(i & -i);
  }
  void add(std::size_t at, std::int32_t some) {
    for (std::size_t i = at + 1; i < sums_.size(); i += i & -i) sums_[i] += some;
  }
  std::int32_t before(std::size_t end) const {
    std::int32_t out = 0;
    for (std::size_t i = end; i > 0; i -= i & -i) out += sums_[i];
    return out;
  }

 private:
  std::vector<std::int32_t> sums_;
};

/// Takes a structure apart, as far as it goes.
class Dismantling {
 public:
  Dismantling(const TargetBricks& target, const Builders& builders,
              std::optional<std::uint32_t> start)
      : target_(target),
        builders_(builders),
        start_(start),
        left_(target.whole()),
        parts_(parts_from(target, start.value_or(0))),
        number_(target.bricks(), static_cast<std::uint32_t>(target.bricks())),
        counts_(target.bricks()) {
    for (std::uint32_t i = 0; i < parts_.order.size(); ++i) number_[parts_.order[i]] = i;
  }

  Remainder run() {
    while (take_some()) {
    }
    Remainder out;
    if (left_.count() < 2) return out;
    for (std::uint32_t i = 0; i < target_.bricks(); ++i) {
      if (left_.has(i) && i != start_) out.barred.push_back(why_not(i));
    }
    out.bricks = left_;
    return out;
  }

 private:
  /// In the order of the numbers and back; false when nothing can be taken.
  bool take_some() {
    const auto count = static_cast<std::uint32_t>(target_.bricks());
    bool some = false;
    for (std::uint32_t k = 0; k < 2 * count; ++k) {
      // Along a path one sets free the next.
      edge_.push_back(k < count ? k : 2 * count - 1 - k);
      while (!edge_.empty()) {
        const std::uint32_t i = edge_.back();
        edge_.pop_back();
        if (!take(i)) continue;
        some = true;
        for (const Offset step : kFaces) edge_.push_back(target_.brick_at(target_.cell(i) + step));
      }
    }
    return some;
  }

  bool take(std::uint32_t i) {
    if (i == TargetBricks::kNone || !left_.has(i) || start_ == i || joins(i)) return false;
    left_.remove(i);
    if (bars_of(target_, left_, i, builders_).size() == builders_.sides.size()) {
      left_.add(i);
      return false;
    }
    counts_.add(number_[i], -1);
    return true;
  }

  BarredBrick why_not(std::uint32_t i) {
    left_.remove(i);
    BarredBrick out{i, bars_of(target_, left_, i, builders_), {}};
    left_.add(i);
    if (out.bars.size() == builders_.sides.size()) return out;
    out.bars.clear();
    out.joins = joined_by(i);
    return out;
  }

  std::int32_t left_in(const std::pair<std::uint32_t, std::uint32_t>& range) const {
    return counts_.before(range.second) - counts_.before(range.first);
  }

  /// Would those that are left fall apart without the brick, which is one of them?
  bool joins(std::uint32_t i) const {
    int parts = 0;
    std::int32_t others = counts_.before(parts_.order.size()) - 1;
    for (const auto& range : parts_.beyond[i]) {
      const std::int32_t here = left_in(range);
      parts += here > 0 ? 1 : 0;
      others -= here;
    }
    return parts + (others > 0 ? 1 : 0) > 1;
  }

  /// Of two such parts a brick each.
  std::pair<std::uint32_t, std::uint32_t> joined_by(std::uint32_t i) const {
    std::vector<std::uint32_t> out;
    const auto& ranges = parts_.beyond[i];
    for (const auto& range : ranges) {
      if (left_in(range) > 0) out.push_back(some_of(range.first));
    }
    if (out.size() > 1) return {out[0], out[1]};
    const auto beyond = [&](std::uint32_t place) {
      return std::any_of(ranges.begin(), ranges.end(), [&](const auto& range) {
        return place >= range.first && place < range.second;
      });
    };
    std::uint32_t place = 0;
    while (!left_.has(parts_.order[place]) || place == number_[i] || beyond(place)) ++place;
    return {out.front(), parts_.order[place]};
  }

  /// The first that is left from this number on.
  std::uint32_t some_of(std::uint32_t place) const {
    while (!left_.has(parts_.order[place])) ++place;
    return parts_.order[place];
  }

  const TargetBricks& target_;
  const Builders& builders_;
  const std::optional<std::uint32_t> start_;
  BrickSet left_;
  const Parts parts_;
  std::vector<std::uint32_t> number_;  ///< by brick, as the parts have it
  Counts counts_;                      ///< of those that are left, by that number
  std::vector<std::uint32_t> edge_;
};

}  // namespace

Remainder find_remainder(const TargetBricks& target, const Builders& builders,
                         std::optional<std::uint32_t> start) {
  assert(!start || *start < target.bricks());
  return Dismantling(target, builders, start).run();
}

}  // namespace stig::assembly
