// SPDX-License-Identifier: MIT
#include "assembly/remainder.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include "assembly/oracle.h"
#include "assembly/targets.h"
#include "compiler/support.h"
#include "support/uses.h"

namespace stig {
namespace {

TargetBricks bricks_of(const std::vector<Cell>& cells) {
  std::vector<PlacedBrick> bricks;
  for (const Cell cell : cells) bricks.push_back({cell, 1});
  return {bricks, 0};
}

const Builders& from_everywhere() {
  static const Builders builders{paper_robot(), {kAllSides.begin(), kAllSides.end()}};
  return builders;
}

TEST_CASE("a mound is left whole by an effector that is wider than a block") {
  std::vector<Cell> cells = {{1, 1, 1}};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) cells.push_back({x, y, 0});
  }
  std::sort(cells.begin(), cells.end());
  const TargetBricks mound = bricks_of(cells);
  const Remainder left = find_remainder(mound, from_everywhere(), std::nullopt);
  CHECK(left.bricks == mound.whole());
  REQUIRE(left.barred.size() == cells.size());
  for (const BarredBrick& one : left.barred) CHECK(one.bars.size() == 4);
  // Of what is barred from everywhere, a start is not spoken of: it is there.
  CHECK(find_remainder(mound, from_everywhere(), 0U).barred.size() == cells.size() - 1);
  Builders narrow = from_everywhere();
  narrow.robot.effector_half_width = narrow.robot.block.side / 2;
  CHECK(find_remainder(mound, narrow, std::nullopt).barred.empty());
}

TEST_CASE("a wall whose ends roll in is left whole: none of them could be the last") {
  // With gaps wide enough for the robot, but from an end no straight way leads out.
  const std::vector<std::pair<int, int>> corners = {{4, 6},   {6, 6},  {6, 0},  {0, 0},  {0, 12},
                                                    {18, 12}, {18, 0}, {12, 0}, {12, 6}, {14, 6}};
  std::set<Cell> cells;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto [x0, x1] = std::minmax(corners[i - 1].first, corners[i].first);
    const auto [y0, y1] = std::minmax(corners[i - 1].second, corners[i].second);
    for (int x = x0; x <= x1; ++x) {
      for (int y = y0; y <= y1; ++y) cells.insert({x, y, 0});
    }
  }
  const TargetBricks rolled = bricks_of({cells.begin(), cells.end()});
  const Remainder left = find_remainder(rolled, from_everywhere(), std::nullopt);
  CHECK(left.bricks == rolled.whole());
  REQUIRE(left.barred.size() == rolled.bricks());
  for (const BarredBrick& one : left.barred) CHECK(one.bars.size() == (one.joins ? 0 : 4));
  // With one end that does not, it is built from the other.
  std::erase_if(cells, [](Cell cell) { return cell.x >= 12 && cell.x < 18 && cell.y == 6; });
  for (int y = 1; y < 6; ++y) cells.erase({12, y, 0});
  const TargetBricks open = bricks_of({cells.begin(), cells.end()});
  CHECK(find_remainder(open, from_everywhere(), std::nullopt).barred.empty());
}

TEST_CASE("an order of work is within reach, step by step, and remainders leave none") {
  CHECK(rc::check([] {
    const auto kind = *rc::gen::elementOf(
        std::vector<std::string_view>(kTargetKinds.begin(), kTargetKinds.end()));
    const Target target = drawn_target(kind, *rc::gen::inRange<std::uint64_t>(1, 1000));
    RC_PRE(target.cells.size() <= 12U);
    const TargetBricks bricks = bricks_of(target.cells);
    std::uint64_t most = 100'000;
    const auto found = find_sequence(bricks, from_everywhere(), std::nullopt, {}, most);
    const Remainder left = find_remainder(bricks, from_everywhere(), std::nullopt);
    const auto possible = can_be_built(bricks, from_everywhere(), 200'000);
    RC_PRE(possible.has_value() && (found || most > 0));
    RC_ASSERT(found.has_value() == *possible);
    if (*possible) RC_ASSERT(left.barred.empty());
    if (!found) return;
    BrickSet state(bricks.bricks());
    state.add(found->bricks.front());
    for (std::size_t i = 1; i < found->bricks.size(); ++i) {
      const Cell cell = bricks.cell(found->bricks[i]);
      RC_ASSERT(reach(bricks, state, cell, found->sides[i], from_everywhere().robot).obstruction ==
                Obstruction::none);
      state.add(found->bricks[i]);
    }
    RC_ASSERT(bricks.complete(state));
  }));
}

TEST_CASE("whatever bricks go first, that there is no order is said of the same targets") {
  CHECK(rc::check([] {
    const auto kind = *rc::gen::elementOf(
        std::vector<std::string_view>(kTargetKinds.begin(), kTargetKinds.end()));
    const Target target = drawn_target(kind, *rc::gen::inRange<std::uint64_t>(1, 100'000));
    RC_PRE(target.cells.size() <= 26U);
    const TargetBricks bricks = bricks_of(target.cells);
    Builders some = from_everywhere();
    some.sides.resize(*rc::gen::inRange<std::size_t>(1, 5));
    const auto order_from = [&](const Builders& builders, std::optional<bool>& found) {
      Liking liking;
      for (int* weight : {&liking.x, &liking.y, &liking.z}) *weight = *rc::gen::inRange(-2, 3);
      liking.chance = *rc::gen::inRange(0, 4);
      liking.seed = *rc::gen::arbitrary<std::uint64_t>();
      liking.in_chains = *rc::gen::arbitrary<bool>();
      std::uint64_t most = 20'000;
      found = find_sequence(bricks, builders, std::nullopt, liking, most).has_value();
      if (!*found && most == 0) found.reset();
    };
    std::optional<bool> first, second, from_all;
    order_from(some, first);
    order_from(some, second);
    order_from(from_everywhere(), from_all);
    if (first && second) RC_ASSERT(*first == *second);
    // More sides to come from bar no order.
    if (first == true && from_all) RC_ASSERT(*from_all);
  }));
}

}  // namespace
}  // namespace stig
