// SPDX-License-Identifier: MIT
// Measures of a built structure. Definitions:
//   components      classes of bricks under face contact
//   mean neighbours mean number of bricks that share a face with a brick
//                   (mean degree of the contact graph)
//   symmetry order  number of maps in the full group about the vertical with
//                   up/down inversion (16 cubic, 24 hexagonal) that carry the
//                   structure, colours included, onto a translate of itself
//   cavities        face-connected classes of empty cells that do not reach the
//                   outside of the bounding box, and their cells
//   height profile  bricks on each level, from the lowest up
// Face contact for bricks and for empty cells alike: the digital-topology pair
// (6, 6) of Kong & Rosenfeld 1989, "Digital topology: introduction and survey".
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lattice/structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

struct Measures {
  std::vector<std::uint64_t> bricks_by_colour;  ///< [0] is colour 1; up to the highest used
  std::optional<CellBounds> bounds;
  std::uint64_t components = 0;
  double mean_neighbours = 0;
  int symmetry_order = 0;
  std::uint64_t cavities = 0;
  std::uint64_t cavity_cells = 0;
  bool cavities_known = true;
  std::vector<std::uint64_t> height_profile;
};

/// Cavities are left at 0 and `cavities_known` false when the bounding box has
/// more than 2^26 cells.
Measures measure(const Structure& structure);

}  // namespace stig::lattice
