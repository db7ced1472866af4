// SPDX-License-Identifier: MIT
#include "lattice/box.h"
#include "support/uses.h"

#include <doctest/doctest.h>

using namespace stig;

TEST_CASE("a box without origin has the start in its middle") {
  const std::vector<PlacedBrick> start{{{5, -3, 0}, 1}};
  const Box box = lay_box({{20, 21, 4}, std::nullopt, false}, start, false);
  CHECK(box.low == Cell{5 - 9, -3 - 10, -1});
  CHECK(box.contains({5, -3, 0}));
}

TEST_CASE("with a floor the box stands on it") {
  const Box box = lay_box({{3, 3, 9}, std::nullopt, false}, {{{0, 0, 0}, 1}}, true);
  CHECK(box.low == Cell{-1, -1, 0});
}

TEST_CASE("a given origin is kept") {
  const Box box = lay_box({{2, 2, 2}, Cell{7, 8, 9}, true}, {{{0, 0, 0}, 1}}, false);
  CHECK(box.low == Cell{7, 8, 9});
  CHECK_FALSE(box.contains({0, 0, 0}));
}

TEST_CASE("a box smaller than the start still lies about its middle") {
  const std::vector<PlacedBrick> start{{{0, 0, 0}, 1}, {{4, 0, 0}, 1}};
  CHECK(lay_box({{3, 1, 1}, std::nullopt, false}, start, false).low.x == 1);
  CHECK(lay_box({{2, 1, 1}, std::nullopt, false}, start, false).low.x == 2);
}

TEST_CASE("periodic boxes wrap, except through a floor") {
  Box box{{0, 0, 0}, {4, 5, 6}, true, false};
  CHECK(box.wrap({-1, 5, 13}) == Cell{3, 0, 1});
  CHECK(box.wrap({3, 4, 5}) == Cell{3, 4, 5});
  box.floor = true;
  CHECK(box.wrap({-1, 5, -1}) == Cell{3, 0, -1});
  box.periodic = false;
  CHECK(box.wrap({-1, 5, -1}) == Cell{-1, 5, -1});
}
