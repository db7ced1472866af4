// SPDX-License-Identifier: MIT
// Structures as shapes: what they are modulo translation and the rotations and mirrors about the
// vertical, and how far one is from another.
#pragma once

#include <cstdint>
#include <vector>

#include "search/genome.h"
#include "search/uses.h"

namespace stig::search {

/// Lattice, shape and colours. Equal for equal structures; cheaper than structure_hash, which sorts
/// the bricks of every image.
std::uint64_t shape_hash(Lattice lattice, const std::vector<PlacedBrick>& bricks);

/// Jaccard's distance of the cells, whatever their colours: of those in the structure or in the
/// target, the share that is not in both; 0 for the same shape. The least over the target's images
/// and over the places in which the brick at (0, 0, 0) fills one of its cells. 1 without a target.
double shape_distance(Lattice lattice, const std::vector<PlacedBrick>& bricks,
                      const std::vector<Cell>& target);

}  // namespace stig::search
