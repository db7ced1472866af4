// SPDX-License-Identifier: MIT
#include "lattice/structure.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>

#include "lattice/cell_marks.h"
#include "support/random_structures.h"
#include "support/uses.h"

using namespace stig;

TEST_CASE("a structure is a map from cells to colours") {
  CHECK(rc::check("like std::map", [] {
    const auto lattice = *rc::gen::element(Lattice::cubic, Lattice::hexagonal);
    const auto bricks = *random_bricks(40, 12);
    std::map<Cell, Colour> oracle;
    Structure s(lattice);
    for (const PlacedBrick& b : bricks) {
      oracle.emplace(b.at, b.brick);
      s.place(b.at, b.brick);
    }
    RC_ASSERT(s.size() == oracle.size());
    for (std::int32_t i = 0; i < 200; ++i) {
      const Cell c{i % 7 * 4 - 12, i / 7 % 7 * 4 - 12, i / 49 * 5 - 12};
      RC_ASSERT(s.at(c) == (oracle.count(c) ? oracle[c] : kEmpty));
    }
    std::vector<PlacedBrick> listed;
    for (const auto& [cell, colour] : oracle) listed.push_back({cell, colour});
    RC_ASSERT(s.bricks() == listed);
  }));
}

TEST_CASE("gathering sees the 5×5×5 cells around, across chunks") {
  CHECK(rc::check("gather equals at", [] {
    const Structure s(Lattice::cubic, *random_bricks(60, 6));
    const Cell centre = *random_cell(8);
    Surroundings around;
    s.gather(centre, around);
    for (int z = -2; z <= 2; ++z) {
      for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
          const auto i = static_cast<std::size_t>(Surroundings::index(x, y, z));
          RC_ASSERT(around.at[i] == s.at(centre + Offset{x, y, z}));
        }
      }
    }
  }));
}

TEST_CASE("far apart cells do not meet") {
  Structure s;
  s.place({1 << 23, 0, 0}, 1);
  s.place({-(1 << 23), 0, 0}, 2);
  s.place({(1 << 23) + (1 << 21), 0, 0}, 3);
  CHECK(s.at({1 << 23, 0, 0}) == 1);
  CHECK(s.at({-(1 << 23), 0, 0}) == 2);
  CHECK(s.at({(1 << 23) + (1 << 21), 0, 0}) == 3);
  CHECK(s.bounds()->size().x == (1 << 24) + (1 << 21) + 1);
}

TEST_CASE("hash and canonical form are those of the class under translation") {
  CHECK(rc::check("translated", [] {
    auto bricks = *random_bricks(30, 5);
    const Structure s(Lattice::cubic, bricks);
    const Offset shift = *random_cell(1000) - Cell{};
    std::reverse(bricks.begin(), bricks.end());
    for (PlacedBrick& b : bricks) b.at = b.at + shift;
    const Structure moved(Lattice::cubic, bricks);
    RC_ASSERT(structure_hash(s) == structure_hash(moved));
    RC_ASSERT(to_origin(s) == to_origin(moved));
    RC_ASSERT(bricks.empty() || to_origin(s).bounds()->low == Cell{});
  }));
}

TEST_CASE("hash and canonical form are those of the class under the group") {
  CHECK(rc::check("turned", [] {
    const auto lattice = *rc::gen::element(Lattice::cubic, Lattice::hexagonal);
    const auto symmetry = *rc::gen::element(Symmetry::rotations, Symmetry::rotations_mirrors);
    const bool inversion = *rc::gen::arbitrary<bool>();
    const Structure s(lattice, *random_bricks(12, 3));
    const auto group = orientations(lattice, symmetry, inversion);
    const auto& g = group[*rc::gen::inRange<std::size_t>(0, group.size())];
    const Structure turned = transformed(s, g);
    RC_ASSERT(structure_hash(s, symmetry, inversion) ==
              structure_hash(turned, symmetry, inversion));
    RC_ASSERT(canonical(s, symmetry, inversion) == canonical(turned, symmetry, inversion));
  }));
}

TEST_CASE("different structures hash differently") {
  const auto hash = [](std::vector<PlacedBrick> bricks) {
    return structure_hash(Structure(Lattice::cubic, bricks));
  };
  const auto one = hash({{{0, 0, 0}, 1}});
  CHECK(one != hash({{{0, 0, 0}, 2}}));
  CHECK(one != hash({{{0, 0, 0}, 1}, {{1, 0, 0}, 1}}));
  CHECK(hash({{{0, 0, 0}, 1}, {{1, 0, 0}, 2}}) != hash({{{0, 0, 0}, 2}, {{1, 0, 0}, 1}}));
  CHECK(one != structure_hash(Structure(Lattice::hexagonal, {{{0, 0, 0}, 1}})));
  CHECK(structure_hash(Structure{}) == structure_hash(Structure{}));
}

TEST_CASE("no two placements near each other have the same hash") {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 16 * 16 * 16; ++i) {
    const Cell c{i % 16 - 8, i / 16 % 16 - 8, i / 256 - 8};
    for (const Colour colour : {Colour{1}, Colour{2}, Colour{3}}) {
      REQUIRE(seen.insert(placement_hash(c, colour)).second);
    }
  }
  const auto pair = [](Cell second) {
    return structure_hash(Structure(Lattice::cubic, {{{0, 0, 0}, 1}, {second, 1}}));
  };
  CHECK(pair({0, 1, 0}) != pair({0, 0, 1}));
  CHECK(pair({1, 0, 0}) != pair({0, 1, 0}));
}

TEST_CASE("cell marks are a map, with its cells listed") {
  CHECK(rc::check("like std::map", [] {
    CellMarks marks;
    std::map<Cell, std::uint64_t> oracle;
    for (int i = 0; i < 300; ++i) {
      const Cell c = *random_cell(4);
      const std::uint64_t value = *rc::gen::inRange<std::uint64_t>(0, 4);
      marks.set(c, value);
      value != 0 ? void(oracle[c] = value) : void(oracle.erase(c));
      RC_ASSERT(marks.size() == oracle.size());
    }
    std::vector<Cell> twos, listed, all;
    for (const auto& [cell, value] : oracle) {
      all.push_back(cell);
      if ((value & 2) != 0) twos.push_back(cell);
    }
    for (std::size_t i = 0; i < marks.size(); ++i) listed.push_back(marks[i]);
    std::sort(listed.begin(), listed.end());
    RC_ASSERT(listed == all);
    RC_ASSERT(marks.cells_with(2) == twos);
    marks.clear();
    RC_ASSERT(marks.size() == 0U);
  }));
}
