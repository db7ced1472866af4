// SPDX-License-Identifier: MIT
// Stretches of slices that are all alike: how many crossings there can be is held to a list of
// them.
#include "assembly/stretch.h"

#include <doctest/doctest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "assembly/assemble.h"
#include "compiler/support.h"
#include "support/uses.h"
#include "synthesis/shapes.h"

namespace stig {
namespace {

TargetBricks bricks_of(const Target& target) {
  std::vector<PlacedBrick> bricks;
  for (const Cell cell : target.cells) bricks.push_back({cell, 1});
  return {bricks, 0};
}

/// Every crossing of two slices of these piles, written down: what is put one after the other, up
/// to the last brick of the slice that is whole first.
std::size_t listed(const std::vector<int>& piles, int colours) {
  std::set<std::string> out;
  std::vector<std::vector<int>> up(2, std::vector<int>(piles.size(), 0));
  int bricks = 0;
  for (const int height : piles) bricks += height;
  std::string way;
  std::vector<int> left = {bricks, bricks};
  const std::function<void()> extend = [&] {
    for (int slice = 0; slice < 2; ++slice) {
      for (std::size_t pile = 0; pile < piles.size(); ++pile) {
        if (up[slice][pile] == piles[pile]) continue;
        ++up[slice][pile];
        --left[slice];
        for (int colour = 0; colour < colours; ++colour) {
          const std::string before = way;
          way += {static_cast<char>('A' + slice), static_cast<char>('a' + pile),
                  static_cast<char>('0' + colour)};
          if (left[slice] == 0) {
            out.insert(way);
          } else {
            extend();
          }
          way = before;
        }
        --up[slice][pile];
        ++left[slice];
      }
    }
  };
  extend();
  return out.size();
}

std::optional<Stretch> too_long(int x, int y, int z, int colours,
                                std::optional<Cell> start = std::nullopt) {
  const TargetBricks target = bricks_of(box({x, y, z}));
  return stretch_too_long(target, start ? std::optional(target.brick_at(*start)) : std::nullopt,
                          colours);
}

TEST_CASE("a stretch is too long when it has more cuts beside the start than there are crossings") {
  struct Slice {
    int y, z, colours;
    std::vector<int> piles;
  };
  for (const Slice& one : {Slice{1, 1, 4, {1}},
                           {1, 2, 3, {2}},
                           {1, 3, 2, {3}},
                           {2, 1, 3, {1, 1}},
                           {2, 2, 1, {2, 2}},
                           {3, 1, 2, {1, 1, 1}}}) {
    const auto most = static_cast<int>(listed(one.piles, one.colours));
    CAPTURE(most);
    // An even number of cuts has half on either side of the start where there are fewest.
    CHECK_FALSE(too_long(2 * most + 1, one.y, one.z, one.colours));
    const auto found = too_long(2 * most + 2, one.y, one.z, one.colours);
    REQUIRE(found);
    CHECK(found->crossings == static_cast<std::uint64_t>(most));
    CHECK(found->bricks_of_slice == static_cast<std::size_t>(one.y * one.z));
    CHECK(too_long(most + 2, one.y, one.z, one.colours, Cell{0, 0, 0}));
    CHECK_FALSE(too_long(most + 1, one.y, one.z, one.colours, Cell{most, 0, 0}));
  }
}

TEST_CASE("slices count as long as they are alike and follow each other, along either axis") {
  Target broken = box({1, 60, 1});
  REQUIRE(stretch_too_long(bricks_of(broken), std::nullopt, 4));
  CHECK_FALSE(stretch_too_long(bricks_of(broken), std::nullopt, 4)->along_x);
  for (int y = 9; y < 60; y += 10) broken.cells.push_back({1, y, 0});
  CHECK_FALSE(stretch_too_long(bricks_of(broken), std::nullopt, 4));
  CHECK_FALSE(too_long(1000, 9, 1, 4));
}

TEST_CASE("a wall of 33 334 bricks on three levels takes more than four colours") {
  AssemblyTask task;
  task.target = box({33'334, 1, 3});
  task.robot = paper_robot();
  task.wording.name = "wall";
  const Assembly made = assemble(task, 1);
  REQUIRE(made.obstacle);
  CHECK(made.obstacle->kind == AssemblyObstacle::Kind::stretch);
  CHECK(made.obstacle->stretch.crossings == 13'952);
  CHECK(takes_more_colours(*made.obstacle));
}

}  // namespace
}  // namespace stig
