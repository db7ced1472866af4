// SPDX-License-Identifier: MIT
// A structure that grows, as an animated binary glTF file: a node for the bricks of each moment,
// which is nothing (scaled to 0) before.
#pragma once

#include <string>
#include <vector>

#include "lattice/structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

/// Bricks that come at one moment.
struct GrowthStep {
  double seconds = 0;
  std::vector<PlacedBrick> bricks;
};

/// The most bricks that make a file of a size that viewers open.
inline constexpr std::size_t kMostGrowing = 100000;

/// Steps in the order of time, no cell twice; those at 0 s or before are there from the beginning.
/// One cell is `scale` units wide; y is up, as with print_glb.
std::string print_growth_glb(Lattice lattice, const std::vector<GrowthStep>& steps,
                             const std::vector<Brick>& bricks, double scale = 1);

}  // namespace stig::lattice
