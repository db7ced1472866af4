// SPDX-License-Identifier: MIT
#include "lattice/measures.h"
#include "support/uses.h"

#include <doctest/doctest.h>

using namespace stig;

namespace {

Structure shell(int side, Lattice lattice = Lattice::cubic) {
  Structure s(lattice);
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) {
        const bool inner = x > 0 && x < side - 1 && y > 0 && y < side - 1 && z > 0 && z < side - 1;
        if (!inner) s.place({x, y, z}, 1);
      }
    }
  }
  return s;
}

}  // namespace

TEST_CASE("an empty structure measures nothing") {
  const Measures m = measure(Structure{});
  CHECK_FALSE(m.bounds);
  CHECK(m.components == 0);
  CHECK(m.symmetry_order == 0);
}

TEST_CASE("a single brick has every symmetry") {
  CHECK(measure(Structure(Lattice::cubic, {{{3, 4, 5}, 2}})).symmetry_order == 16);
  CHECK(measure(Structure(Lattice::hexagonal, {{{3, 4, 5}, 2}})).symmetry_order == 24);
}

TEST_CASE("a hollow cube has one cavity") {
  const Measures m = measure(shell(5));
  CHECK(m.cavities == 1);
  CHECK(m.cavity_cells == 27);
  CHECK(m.components == 1);
  CHECK(m.symmetry_order == 16);
  CHECK(m.height_profile == std::vector<std::uint64_t>{25, 16, 16, 16, 25});
  CHECK(m.bricks_by_colour == std::vector<std::uint64_t>{98});
}

TEST_CASE("a cavity open at an edge alone is still closed, since faces connect") {
  Structure s = shell(3);
  CHECK(measure(s).cavities == 1);
  Structure open;
  for (const PlacedBrick& b : s.bricks()) {
    if (b.at != Cell{0, 1, 1}) open.place(b.at, b.brick);  // a face cell: opens it
  }
  CHECK(measure(open).cavities == 0);
  Structure edge;
  for (const PlacedBrick& b : s.bricks()) {
    if (b.at != Cell{0, 0, 1}) edge.place(b.at, b.brick);
  }
  CHECK(measure(edge).cavities == 1);
}

TEST_CASE("components touch by faces") {
  const Structure s(Lattice::cubic,
                    {{{0, 0, 0}, 1}, {{1, 0, 0}, 2}, {{2, 1, 0}, 1}, {{9, 9, 9}, 3}});
  const Measures m = measure(s);
  CHECK(m.components == 3);
  CHECK(m.mean_neighbours == doctest::Approx(0.5));
  CHECK(m.bricks_by_colour == std::vector<std::uint64_t>{2, 1, 1});
  CHECK(m.symmetry_order == 1);
}

TEST_CASE("colours count in symmetry") {
  CHECK(measure(Structure(Lattice::cubic, {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}})).symmetry_order == 8);
  CHECK(measure(Structure(Lattice::cubic, {{{0, 0, 0}, 1}, {{1, 0, 0}, 2}})).symmetry_order == 4);
}

TEST_CASE("hexagonal contacts have eight faces") {
  Structure flower(Lattice::hexagonal);
  flower.place({0, 0, 0}, 1);
  const Neighbourhood& n = neighbourhood(Lattice::hexagonal);
  for (std::size_t i = 0; i < 20; ++i) {
    if (n.is_face[i]) flower.place(Cell{} + n.offsets[i], 1);
  }
  const Measures m = measure(flower);
  CHECK(m.components == 1);
  CHECK(m.symmetry_order == 24);
  CHECK(m.mean_neighbours == doctest::Approx(2.0 * (8 + 6) / 9));
}

TEST_CASE("a structure far too wide to flood says so") {
  const Structure s(Lattice::cubic, {{{0, 0, 0}, 1}, {{1 << 20, 1 << 20, 5}, 1}});
  const Measures m = measure(s);
  CHECK_FALSE(m.cavities_known);
  CHECK(m.components == 2);
}
