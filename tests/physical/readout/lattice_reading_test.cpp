// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <numbers>
#include <set>

#include "physical/readout/lattice_reading.h"
#include "support/uses.h"

namespace stig {
namespace {

constexpr double kBlockSide = 0.055;

std::vector<LatticeCell> pyramid() {
  std::vector<LatticeCell> cells;
  for (int z = 0; z < 3; ++z) {
    for (int x = z; x < 5 - z; ++x) {
      for (int y = z; y < 5 - z; ++y) cells.push_back({x, y, z});
    }
  }
  return cells;
}

/// Blocks in these cells of a lattice that stands anywhere, each turned in its own way.
std::vector<PlacedBlock> place(const std::vector<LatticeCell>& cells, const Pose& X_WL,
                               double pitch = kBlockSide) {
  std::vector<PlacedBlock> out;
  const double quarter = std::numbers::pi / 2;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vec3 c{double(cells[i].x), double(cells[i].y), double(cells[i].z)};
    const Quat own =
        rotation({0, 0, quarter * double(i % 4)}) * rotation({quarter * double(i / 4 % 4), 0, 0});
    out.push_back({{X_WL * (c * pitch), X_WL.q * own}, static_cast<std::uint8_t>(1 + i % 4)});
  }
  return out;
}

std::set<LatticeCell> cells_of(const ReadLattice& lattice) {
  std::set<LatticeCell> out;
  for (const ReadBlock& block : lattice.blocks) out.insert(block.cell);
  return out;
}

TEST_CASE("a pyramid is read back, its blocks turned and the whole anywhere") {
  const auto cells = pyramid();
  const Pose X_WL{{0.3, -0.2, 0.0275}, rotation({0, 0, 0.5})};
  const auto reading = read_lattices(place(cells, X_WL));
  REQUIRE(reading.lattices.size() == 1);
  CHECK(reading.loose.empty());
  const ReadLattice& lattice = reading.lattices.front();
  CHECK(cells_of(lattice) == std::set<LatticeCell>(cells.begin(), cells.end()));
  CHECK(lattice.yaw == doctest::Approx(0.5));
  CHECK(lattice.tilt == doctest::Approx(0).epsilon(1e-7));
  CHECK(lattice.pitch == doctest::Approx(kBlockSide));
  CHECK(length(lattice.X_WL.p - X_WL.p) < 1e-9);
  CHECK(lattice.worst_offset < 1e-9);
  for (const ReadBlock& block : lattice.blocks) {
    CHECK(block.offset < 1e-9);
    CHECK(block.turn < 1e-6);
    CHECK(block.colour == 1 + block.block % 4);
  }
}

TEST_CASE("the pitch is that of the blocks as they lie") {
  const auto reading =
      read_lattices(place({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {}, 0.0553));
  REQUIRE(reading.lattices.size() == 1);
  CHECK(reading.lattices[0].pitch == doctest::Approx(0.0553));
  CHECK(reading.lattices[0].blocks[0].offset < 1e-9);
}

TEST_CASE("a block askew is told in millimetres and radians") {
  auto blocks = place(pyramid(), {});
  PlacedBlock& top = blocks.back();
  top.X_WB.p += {0.003, 0, 0};
  top.X_WB.q = rotation({0, 0, 0.1}) * top.X_WB.q;
  const auto reading = read_lattices(blocks);
  REQUIRE(reading.lattices.size() == 1);
  const auto& read = reading.lattices[0].blocks.back();
  CHECK(read.block == blocks.size() - 1);
  CHECK(read.offset == doctest::Approx(0.003).epsilon(0.05));
  CHECK(read.turn == doctest::Approx(0.1).epsilon(0.05));
  CHECK(reading.lattices[0].worst_offset > 0.0029);
  CHECK(reading.lattices[0].worst_turn == doctest::Approx(0.1).epsilon(0.01));
}

TEST_CASE("what is too far off, too turned, or alone is loose") {
  auto blocks = place({{0, 0, 0}, {1, 0, 0}, {9, 0, 0}}, {});
  blocks.push_back({{{0, kBlockSide + 0.013, 0}, {}}, 0});
  blocks.push_back({{{0, -kBlockSide, 0}, rotation({0, 0, 0.3})}, 0});
  const auto reading = read_lattices(blocks);
  CHECK(reading.lattices.size() == 1);
  CHECK(reading.loose == std::vector<std::size_t>{2, 3, 4});
}

TEST_CASE("two structures, the larger first") {
  auto blocks = place({{0, 0, 0}, {1, 0, 0}}, {{1, 1, 0.0275}, rotation({0, 0, -0.3})});
  for (const auto& block : place({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {})) blocks.push_back(block);
  const auto reading = read_lattices(blocks);
  REQUIRE(reading.lattices.size() == 2);
  CHECK(reading.lattices[0].blocks.size() == 3);
  CHECK(reading.lattices[1].yaw == doctest::Approx(-0.3));
}

TEST_CASE("a row has no turn about itself but its blocks' own") {
  const auto reading = read_lattices(place({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {}));
  REQUIRE(reading.lattices.size() == 1);
  CHECK(reading.lattices[0].tilt < 1e-6);
}

TEST_CASE("two blocks in one cell: the better stays") {
  auto blocks = place({{0, 0, 0}, {1, 0, 0}}, {});
  blocks.push_back({{{kBlockSide + 0.004, 0, 0}, {}}, 0});
  const auto reading = read_lattices(blocks);
  REQUIRE(reading.lattices.size() == 1);
  CHECK(reading.lattices[0].blocks.size() == 2);
  CHECK(reading.loose == std::vector<std::size_t>{2});
}

TEST_CASE("none and one") {
  CHECK(read_lattices({}).lattices.empty());
  CHECK(read_lattices(place({{0, 0, 0}}, {})).loose.size() == 1);
}

TEST_CASE("any lattice with little noise is read back, whatever the order of blocks") {
  CHECK(rc::check("noisy lattices", [] {
    const auto number = [](double most) {
      return most * (static_cast<double>(*rc::gen::inRange(-1000, 1001)) / 1000);
    };
    const Pose X_WL{{number(2), number(2), number(2)},
                    normalised(rotation({0, 0, number(0.7)}) * rotation({number(0.05), 0, 0}))};
    auto cells = pyramid();
    auto blocks = place(cells, X_WL);
    for (PlacedBlock& block : blocks) {
      block.X_WB.p += {number(0.001), number(0.001), number(0.001)};
      block.X_WB.q =
          normalised(rotation({number(0.02), number(0.02), number(0.02)}) * block.X_WB.q);
    }
    for (PlacedBlock& block : blocks) {
      std::swap(block, blocks[*rc::gen::inRange<std::size_t>(0, blocks.size())]);
    }
    const auto reading = read_lattices(blocks);
    RC_ASSERT(reading.lattices.size() == 1U);
    const ReadLattice& lattice = reading.lattices[0];
    RC_ASSERT(cells_of(lattice) == std::set<LatticeCell>(cells.begin(), cells.end()));
    for (const ReadBlock& block : lattice.blocks) {
      RC_ASSERT(block.offset < 0.003);
      RC_ASSERT(block.turn < 0.05);
    }
  }));
}

}  // namespace
}  // namespace stig
