// SPDX-License-Identifier: MIT
// Rows beside a spine: which bricks share a colour, and which likings begin so.
#include "assembly/texture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "assembly/counted.h"
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

/// The number that the rows below the border show, the lowest digit in row 0.
int number_at(const TargetBricks& target, const Texture& texture, int digits, int x) {
  // Behind the end, in the highest digit's row, there are zeros up to the last column.
  const std::uint32_t zero =
      texture[target.brick_at({target.cell(target.bricks() - 1).x - 1, digits - 1, 0})];
  int out = 0;
  for (int row = 0; row < digits; ++row) {
    if (texture[target.brick_at({x, row, 0})] != zero) out |= 1 << row;
  }
  return out;
}

TEST_CASE("rows that count go up by one a column and carry over once, in time for the end") {
  for (const int wide : {16, 23, 40, 77}) {
    CAPTURE(wide);
    const TargetBricks target = rectangle(wide, wide);
    const auto rows = rows_to_count(target);
    REQUIRE(rows);
    const int digits = *rows - 1;
    const Texture texture = counted_texture(target, *rows);
    // The end takes a column for each digit on its way down.
    const int carry = wide - digits;
    for (int x = digits; x < carry; ++x) {
      CHECK(number_at(target, texture, digits, x) == (1 << digits) - (carry - x));
    }
    const std::uint32_t end = texture[target.brick_at({wide - 1, wide - 1, 0})];
    for (int i = 0; i + 1 < digits; ++i) {
      CHECK(texture[target.brick_at({carry + i, digits - 1 - i, 0})] == end);
      CHECK(texture[target.brick_at({digits - 1 - i, carry + i, 0})] == end);
    }
  }
}

TEST_CASE("rows to count are as few as hold the longer side, and the corner is the solver's") {
  CHECK(rows_to_count(rectangle(16, 16)) == 5);
  CHECK(rows_to_count(rectangle(76, 76)) == 7);
  CHECK(rows_to_count(rectangle(77, 40)) == 8);
  CHECK(rows_to_count(rectangle(40, 77)) == 8);
  CHECK_FALSE(rows_to_count(rectangle(10, 77)));
  CHECK_FALSE(rows_to_count(TargetBricks({{{0, 0, 0}, 1}, {{1, 1, 0}, 1}}, 0)));
  const TargetBricks target = rectangle(16, 16);
  const Texture texture = counted_texture(target, 5);
  for (std::uint32_t i = 0; i < target.bricks(); ++i) {
    const Cell c = target.cell(i);
    if (c.x < 4 && c.y < 4) CHECK(texture[i] == i);
  }
}

TEST_CASE("a plate is counted when a spine would be long, with four colours and from two sides") {
  const auto counts = [](const Liking& one) { return one.counting_rows > 0; };
  const auto small = large_likings(rectangle(40, 40), 4);
  CHECK(counts(small.back()));
  const auto large = large_likings(rectangle(77, 77), 4);
  CHECK(counts(large.front()));
  CHECK(std::none_of(large.begin() + 1, large.end(), counts));
  const auto three = large_likings(rectangle(77, 77), 3);
  CHECK(std::none_of(three.begin(), three.end(), counts));
  CHECK(suits(rectangle(77, 77), large.front(), {ApproachSide::plus_y, ApproachSide::plus_x}));
  CHECK_FALSE(suits(rectangle(77, 77), large.front(), {ApproachSide::plus_y}));
}

}  // namespace
}  // namespace stig
