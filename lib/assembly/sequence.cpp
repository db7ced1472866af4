// SPDX-License-Identifier: MIT
#include "assembly/sequence.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <numeric>
#include <set>

#include "assembly/counted.h"
#include "assembly/last_brick.h"
#include "assembly/path.h"
#include "assembly/span.h"
#include "base/hash.h"

namespace stig::assembly {

namespace {

/// Outweighs the other terms of a score, so that rows decide first.
constexpr std::int64_t kSpine = 100'000;
/// For each step along a path.
constexpr std::int64_t kStep = 100;

std::int32_t across_spine(const Liking& liking, Cell cell) {
  return liking.spine == Liking::Spine::along_x ? cell.y : cell.x;
}

/// Bricks as they are liked to go, the first first.
std::vector<std::uint32_t> by_liking(const TargetBricks& target, const Liking& liking) {
  const Span wide = span_of(target, &Cell::x), deep = span_of(target, &Cell::y);
  const SpineRows spine =
      liking.spine == Liking::Spine::none ? SpineRows{} : spine_rows(target, liking);
  std::vector<std::int64_t> score(target.bricks());
  const std::vector<int> steps = liking.round
                                     ? steps_from(target, liking.round->first, liking.round->last)
                                     : std::vector<int>(target.bricks());
  for (std::size_t i = 0; i < score.size(); ++i) {
    const Cell c = target.cell(i);
    const int row =
        liking.spine == Liking::Spine::none ? 0 : std::abs(spine.beside(across_spine(liking, c)));
    const bool swept = liking.swept && row > 0;
    const int x = liking.middle_x && !swept ? wide.from_middle(c.x) : c.x;
    const int y = liking.middle_y && !swept ? deep.from_middle(c.y) : c.y;
    score[i] =
        std::int64_t{liking.x} * x + std::int64_t{liking.y} * y + std::int64_t{liking.z} * c.z;
    score[i] += kSpine * row + kStep * steps[i];
    if (liking.counting_rows > 0) score[i] = counted_turn(liking.counting_rows, wide, deep, c);
    if (liking.chance > 0) {
      score[i] += static_cast<std::int64_t>(combine(liking.seed, i) %
                                            static_cast<std::uint64_t>(liking.chance));
    }
  }
  std::vector<std::uint32_t> out(target.bricks());
  std::iota(out.begin(), out.end(), 0U);
  // Stable: bricks of the same score stay in the target's order, on every machine.
  std::stable_sort(out.begin(), out.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return score[a] > score[b]; });
  return out;
}

class Dismantler {
 public:
  Dismantler(const TargetBricks& target, const Builders& builders,
             std::optional<std::uint32_t> start, const Liking& liking, std::uint64_t& most)
      : target_(target),
        builders_(builders),
        start_(start),
        liking_(liking),
        order_(by_liking(target, liking)),
        most_(most),
        left_(target.whole()),
        connected_(target),
        obstacles_(target.bricks()) {}

  std::optional<Sequence> run() {
    // Depth first. A place in order_ is all that a choice needs, so undoing one goes on behind it.
    std::size_t next = 0;  // in order_, of what to try now
    while (gone_.size() + 1 < target_.bricks()) {
      if (remove_one(next)) {
        next = 0;
        continue;
      }
      // Whether a set of bricks can be taken apart does not depend on how it was reached, so it
      // need not be tried again.
      dead_.insert(left_);
      if (gone_.empty() || most_ == 0) return std::nullopt;
      next = gone_.back().place + 1;
      left_.add(brick_of(gone_.back()));
      gone_.pop_back();
    }
    return sequence();
  }

 private:
  struct Gone {
    std::size_t place = 0;  ///< in order_, gone through twice: first those that follow
    ApproachSide side{};
  };

  std::uint32_t brick_of(const Gone& gone) const { return order_[gone.place % order_.size()]; }

  /// Is it to be tried first, since it is next to the last that went? So a structure is left along
  /// paths. Where the liking is not for chains, scores alone decide.
  bool follows(std::uint32_t brick) const {
    if (!liking_.in_chains || gone_.empty()) return true;
    const Offset apart = target_.cell(brick) - target_.cell(brick_of(gone_.back()));
    return std::abs(apart.x) + std::abs(apart.y) + std::abs(apart.z) == 1;
  }

  /// Can what is left be a start?
  bool can_begin() const {
    if (gone_.size() + 2 != target_.bricks() || start_) return true;
    for (std::uint32_t i = 0; i < target_.bricks(); ++i) {
      if (left_.has(i)) return target_.cell(i).z == target_.floor_level();
    }
    return false;
  }

  /// Is it known that it cannot go, as long as what was in the way stands?
  bool stays(std::uint32_t brick) const {
    const std::vector<std::uint32_t>& obstacles = obstacles_[brick];
    return !obstacles.empty() && std::all_of(obstacles.begin(), obstacles.end(),
                                             [&](std::uint32_t one) { return left_.has(one); });
  }

  bool remove_one(std::size_t from) {
    for (std::size_t i = from; i < 2 * order_.size() && most_ > 0; ++i) {
      const std::uint32_t brick = order_[i % order_.size()];
      if (!left_.has(brick) || start_ == brick || follows(brick) != (i < order_.size())) continue;
      if (stays(brick)) continue;
      --most_;
      left_.remove(brick);
      // One brick is put next to another, so what is left hangs together.
      if (!dead_.contains(left_) && connected_.without(left_, brick) && can_begin()) {
        obstacles_[brick].clear();
        if (const auto side = side_for(target_, left_, brick, builders_, &obstacles_[brick])) {
          gone_.push_back({i, *side});
          return true;
        }
      }
      left_.add(brick);
    }
    return false;
  }

  Sequence sequence() const {
    Sequence out;
    for (std::uint32_t i = 0; i < target_.bricks(); ++i) {
      if (left_.has(i)) out.bricks.push_back(i);
    }
    // The start is put by nobody; its side is a filler.
    out.sides.push_back(builders_.sides.front());
    for (std::size_t i = gone_.size(); i-- > 0;) {
      out.bricks.push_back(brick_of(gone_[i]));
      out.sides.push_back(gone_[i].side);
    }
    return out;
  }

  const TargetBricks& target_;
  const Builders& builders_;
  std::optional<std::uint32_t> start_;
  const Liking& liking_;
  std::vector<std::uint32_t> order_;
  std::uint64_t& most_;
  BrickSet left_;
  Connected connected_;
  std::vector<Gone> gone_;
  std::set<BrickSet> dead_;
  std::vector<std::vector<std::uint32_t>> obstacles_;  ///< by brick; empty: nothing is known
};

}  // namespace

SpineRows spine_rows(const TargetBricks& target, const Liking& liking) {
  assert(liking.spine != Liking::Spine::none);
  const Span span = span_of(target, liking.spine == Liking::Spine::along_x ? &Cell::y : &Cell::x);
  // The lower one where two are in the middle; an even number of rows has one more above it than
  // below.
  const int middle = span.low + (span.high - span.low) / 2;
  const int first = middle - (liking.spine_rows - 1) / 2;
  return {first, first + liking.spine_rows - 1};
}

std::optional<Sequence> find_sequence(const TargetBricks& target, const Builders& builders,
                                      std::optional<std::uint32_t> start, const Liking& liking,
                                      std::uint64_t& most) {
  assert(!start || *start < target.bricks());
  return Dismantler(target, builders, start, liking, most).run();
}

}  // namespace stig::assembly
