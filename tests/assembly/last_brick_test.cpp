// SPDX-License-Identifier: MIT
// What is kept of earlier answers against asking anew, on parts of targets by chance.
#include "assembly/last_brick.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "assembly/remainder.h"
#include "assembly/targets.h"
#include "compiler/columns.h"
#include "compiler/support.h"
#include "support/uses.h"

namespace stig {
namespace {

const Builders& everywhere() {
  static const Builders builders{paper_robot(), {kAllSides.begin(), kAllSides.end()}};
  return builders;
}

TargetBricks target_by_chance() {
  const auto kind =
      *rc::gen::elementOf(std::vector<std::string_view>(kTargetKinds.begin(), kTargetKinds.end()));
  std::vector<PlacedBrick> bricks;
  for (const Cell cell : drawn_target(kind, *rc::gen::inRange<std::uint64_t>(1, 1000)).cells) {
    bricks.push_back({cell, 1});
  }
  return {bricks, 0};
}

std::uint32_t brick_by_chance(const TargetBricks& target) {
  return *rc::gen::inRange(0U, static_cast<std::uint32_t>(target.bricks()));
}

BrickSet part_of(const TargetBricks& target) {
  BrickSet out(target.bricks());
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    if (*rc::gen::inRange(0, 3) > 0) out.add(i);
  }
  return out;
}

/// By steps from brick to brick.
bool hangs_together(const TargetBricks& target, const BrickSet& left) {
  std::vector<std::uint32_t> met;
  for (std::uint32_t i = 0; i < target.bricks() && met.empty(); ++i) {
    if (left.has(i)) met.push_back(i);
  }
  BrickSet known(target.bricks());
  if (!met.empty()) known.add(met.front());
  for (std::size_t next = 0; next < met.size(); ++next) {
    for (std::uint32_t i = 0; i < target.bricks(); ++i) {
      const Offset apart = target.cell(i) - target.cell(met[next]);
      if (std::abs(apart.x) + std::abs(apart.y) + std::abs(apart.z) != 1) continue;
      if (!left.has(i) || known.has(i)) continue;
      known.add(i);
      met.push_back(i);
    }
  }
  return known == left;
}

TEST_CASE("what hangs together is known from what is about the brick that went") {
  CHECK(rc::check([] {
    const TargetBricks target = target_by_chance();
    Connected connected(target);
    BrickSet left = target.whole();
    while (left.count() > 1) {
      // The next that is left from there on: a drawn number alone might be the same for ever.
      std::uint32_t brick = brick_by_chance(target);
      while (!left.has(brick)) brick = (brick + 1) % static_cast<std::uint32_t>(target.bricks());
      left.remove(brick);
      const bool expected = hangs_together(target, left);
      RC_ASSERT(connected.without(left, brick) == expected);
      if (!expected) return;
    }
  }));
}

TEST_CASE("a brick cannot be put as long as its obstacles stand, whatever else does") {
  int known = 0;
  CHECK(rc::check([&] {
    const TargetBricks target = target_by_chance();
    const auto brick = brick_by_chance(target);
    BrickSet state = part_of(target);
    state.remove(brick);
    std::vector<std::uint32_t> obstacles;
    const auto side = side_for(target, state, brick, everywhere(), &obstacles);
    RC_ASSERT(side == side_for(target, state, brick, everywhere()));
    if (side || obstacles.empty()) return;
    ++known;
    BrickSet other = part_of(target);
    for (const std::uint32_t one : obstacles) other.add(one);
    other.remove(brick);
    RC_ASSERT_FALSE(side_for(target, other, brick, everywhere()).has_value());
  }));
  CHECK(known > 10);
}

TEST_CASE("one column is before a robot exactly where it is among all that are") {
  CHECK(rc::check([] {
    const TargetBricks target = target_by_chance();
    const BrickSet state = part_of(target);
    for (const ApproachSide side : kAllSides) {
      const auto all = columns_before(target, state, side);
      for (int u = -8; u <= 8; ++u) {
        for (int v = -8; v <= 8; ++v) {
          const bool among = std::find(all.begin(), all.end(), std::pair(v, u)) != all.end();
          RC_ASSERT(comes_to_column(target, state, side, u, v) == among);
        }
      }
    }
  }));
}

TEST_CASE("the remainder is the same in whatever order bricks are numbered") {
  CHECK(rc::check([] {
    const TargetBricks target = target_by_chance();
    std::vector<PlacedBrick> turned;
    for (std::size_t i = target.bricks(); i-- > 0;) turned.push_back({target.cell(i), 1});
    const Remainder one = find_remainder(target, everywhere(), std::nullopt);
    const Remainder other = find_remainder({turned, 0}, everywhere(), std::nullopt);
    RC_ASSERT(one.barred.size() == other.barred.size());
    for (const BarredBrick& barred : one.barred) {
      RC_ASSERT(other.bricks.has(target.bricks() - 1 - barred.brick));
    }
  }));
}

}  // namespace
}  // namespace stig
