// SPDX-License-Identifier: MIT
// Rows beside a spine: which bricks share a colour, and which likings begin so.
#include "assembly/texture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "assembly/likings.h"
#include "support/uses.h"

namespace stig {
namespace {

TargetBricks rectangle(int wide, int deep) {
  std::vector<PlacedBrick> bricks;
  for (int x = 0; x < wide; ++x) {
    for (int y = 0; y < deep; ++y) bricks.push_back({{x, y, 0}, 1});
  }
  return {bricks, 0};
}

/// A letter for each brick, rows from the farthest to the nearest: the same for one colour, `s`
/// for a brick of its own.
std::string drawn(const TargetBricks& target, const Texture& texture, int wide, int deep) {
  std::vector<int> shared(target.bricks(), 0);
  for (const std::uint32_t first : texture) ++shared[first];
  std::vector<std::uint32_t> known;
  std::string out;
  for (int y = deep; y-- > 0;) {
    for (int x = 0; x < wide; ++x) {
      const std::uint32_t first = texture[target.brick_at({x, y, 0})];
      if (shared[first] == 1) {
        out += 's';
        continue;
      }
      const auto at = std::find(known.begin(), known.end(), first);
      out += static_cast<char>('a' + (at - known.begin()));
      if (at == known.end()) known.push_back(first);
    }
    out += '\n';
  }
  return out;
}

TEST_CASE("rows that are swept have two lines of other colours, aslant and along their ends") {
  const TargetBricks target = rectangle(6, 6);
  Liking liking;
  liking.spine = Liking::Spine::along_x;
  liking.swept = true;
  CHECK(drawn(target, texture_of(target, liking), 6, 6) ==
        "abbbbc\n"
        "babbbc\n"
        "ssssss\n"
        "ssssss\n"
        "dedddf\n"
        "eddddf\n");
  liking.spine_rows = 4;  // a row on either side, whose line is a single brick
  CHECK(drawn(target, texture_of(target, liking), 6, 6) ==
        "saaaas\n"
        "ssssss\n"
        "ssssss\n"
        "ssssss\n"
        "ssssss\n"
        "sbbbbs\n");
  liking.spine = Liking::Spine::none;
  CHECK(texture_of(target, liking) == no_texture(target.bricks()));
}

TEST_CASE(
    "rows are swept only beside a spine that is as long as they are many, the shorter first") {
  const auto square = swept_likings(rectangle(20, 20), 4);
  REQUIRE(square.size() == 4);
  CHECK(square.front().spine == Liking::Spine::along_x);
  CHECK(square.front().spine_rows == 2);
  CHECK(square.back().from_ends);
  for (const Liking& one : swept_likings(rectangle(5, 40), 4)) {
    CHECK(one.spine == Liking::Spine::along_y);
    CHECK(one.from_ends);  // two rows count as far as 31
  }
  CHECK(swept_likings(rectangle(31, 31), 4).front().spine_rows == 2);
  CHECK(swept_likings(rectangle(32, 32), 4).front().spine_rows == 3);
  CHECK(swept_likings(rectangle(30, 16), 4).front().spine == Liking::Spine::along_y);
}

TEST_CASE("a spine wants robots at its sides, or at its ends and beside the rows that follow") {
  using Sides = std::vector<ApproachSide>;
  const Sides ends = {ApproachSide::plus_x, ApproachSide::minus_x};
  const Sides flanks = {ApproachSide::plus_y, ApproachSide::minus_y};
  const Sides all = {kAllSides.begin(), kAllSides.end()};
  Liking liking;
  liking.spine = Liking::Spine::along_x;
  CHECK(suits(rectangle(9, 9), liking, flanks));
  CHECK_FALSE(suits(rectangle(9, 9), liking, ends));
  CHECK(suits(rectangle(9, 9), liking, all));
  liking.swept = true;
  CHECK_FALSE(suits(rectangle(9, 9), liking, all));
  liking.from_ends = true;
  liking.spine_rows = 3;
  CHECK_FALSE(suits(rectangle(9, 9), liking, ends));
  CHECK_FALSE(suits(rectangle(9, 9), liking, flanks));
  CHECK(suits(rectangle(9, 9), liking, all));
  CHECK(suits(rectangle(9, 3), liking, ends));
}

}  // namespace
}  // namespace stig
