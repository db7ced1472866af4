// SPDX-License-Identifier: MIT
// Orientations of a pattern: the rotations and mirrors under which a rule is
// meant. A rule written once stands for its image under every orientation.
//
// rotations: C4 (cubic) or C6 (hexagonal) about the vertical, the generator being
// (x, y) -> (-y, x), or (q, r) -> (-r, q + r). mirrors: D4 or D6, the added mirror
// being (x, y) -> (-x, y), or (q, r) -> (-q - r, r). inversion: z -> -z as well.
// Orientation 0 is always the identity.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "rules/neighbourhood.h"

namespace stig::rules {

enum class Symmetry : std::uint8_t { none, rotations, rotations_mirrors };

std::string_view to_string(Symmetry symmetry);  ///< as written in a file: "rotations+mirrors"

/// One orientation g, as a linear map of offsets and as a permutation of
/// neighbour indices.
struct Orientation {
  /// g·(x, y, z) = (xx·x + xy·y, yx·x + yy·y, zz·z)
  int xx = 1, xy = 0, yx = 0, yy = 1, zz = 1;
  /// image[i] is the index of g·offsets[i].
  std::array<std::int8_t, kMaxNeighbours> image{};
  std::string name;  ///< "0°", "90°", "mirrored 180°", "60° upside down", …

  constexpr Offset apply(Offset o) const {
    return {xx * o.x + xy * o.y, yx * o.x + yy * o.y, zz * o.z};
  }
};

/// The group's elements, identity first, rotations by rising angle, then mirrors,
/// then the same upside down.
std::vector<Orientation> orientations(Lattice lattice, Symmetry symmetry, bool inversion);

}  // namespace stig::rules
