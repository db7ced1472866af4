// SPDX-License-Identifier: MIT
// Reading a built structure from the poses of its blocks: which blocks form lattices, which
// cell each fills, and how far off it is.
//
//     for (const ReadLattice& lattice : read_lattices(blocks).lattices) …
//
// Two blocks are joined when one lies where the other's neighbour across a face would be,
// give or take `Tolerance`. Joins are followed from the best to the worst, so that a block
// askew does not lead its neighbours astray; then one lattice is fitted to the blocks of each
// cluster, by least squares over positions and axes (Horn 1987), its pitch included. The cube
// looks the same in 24 positions: a block's turn is taken up to those, the lattice's so that
// its z axis is the one nearest the world's and its yaw within ±45°.
//
// What is no business of this file: whether the structure is the right one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace stig::physics {

struct PlacedBlock {
  Pose X_WB;
  std::uint8_t colour = 0;  ///< 0: dark; 1 to 4: Q1 to Q4
};

struct LatticeCell {
  int x = 0, y = 0, z = 0;

  friend auto operator<=>(const LatticeCell&, const LatticeCell&) = default;
};

struct ReadBlock {
  std::size_t block = 0;  ///< its place in the list given
  LatticeCell cell;       ///< from (0, 0, 0), the lowest in each direction
  std::uint8_t colour = 0;
  double offset = 0;  ///< m, of its centre from the cell's
  double turn = 0;    ///< rad, of its axes from the lattice's
};

struct ReadLattice {
  Pose X_WL;                      ///< centre of cell (0, 0, 0), and the axes
  double pitch = 0;               ///< m from cell to cell, fitted
  double yaw = 0;                 ///< rad about the vertical, within ±π/4
  double tilt = 0;                ///< rad, of the lattice's z axis from the vertical
  std::vector<ReadBlock> blocks;  ///< by (z, y, x) of their cells
  /// The worst of two neighbours, one against the other.
  double worst_offset = 0, worst_turn = 0;
};

struct StructureReading {
  std::vector<ReadLattice> lattices;  ///< the largest first, then by their first block
  std::vector<std::size_t> loose;     ///< blocks in no lattice
};

struct Tolerance {
  double offset = 0.012;  ///< m, of a neighbour from where it should be
  double turn = 0.26;     ///< rad, of its axes
};

/// What a rotation turns beyond the nearest of the cube's 24 positions: r = beyond · position.
Mat3 beyond_cube_turn(const Mat3& r);

/// Lattices of two blocks and more. `side` is that of the blocks, m. Time and memory are
/// about linear in the number of blocks.
StructureReading read_lattices(const std::vector<PlacedBlock>& blocks, double side = 0.055,
                               const Tolerance& tolerance = {});

}  // namespace stig::physics
