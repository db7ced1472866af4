// SPDX-License-Identifier: MIT
// Both neighbourhoods are computed at compile time from the definition in the header, in
// the reading order of drawings, and checked by static_assert. The order is part of file
// formats: certificates and traces name neighbours by index.
#include "rules/neighbourhood.h"

namespace stig::rules {
namespace {

constexpr bool on_lattice(Lattice lattice, Offset o) {
  // The two corners (1,1) and (-1,-1) of a 3×3 axial slice are no neighbours. In axial
  // coordinates the six neighbours in the plane are those with |q + r| <= 1.
  return lattice == Lattice::cubic || (o.x + o.y >= -1 && o.x + o.y <= 1);
}

constexpr Neighbourhood make(Lattice lattice) {
  Neighbourhood n;
  n.index_by_box.fill(-1);
  for (int z = 1; z >= -1; --z) {
    if (z == -1) n.first_below = n.size;
    for (int y = 1; y >= -1; --y) {
      for (int x = -1; x <= 1; ++x) {
        const Offset o{x, y, z};
        if (o == Offset{} || !on_lattice(lattice, o)) continue;
        const auto i = static_cast<std::size_t>(n.size);
        n.offsets[i] = o;
        // On the cubic lattice the squared length tells faces (1), edges (2) and corners
        // (3) apart. A hexagonal prism shares faces with its six neighbours on the level
        // and with those straight above and below.
        const int steps = x * x + y * y + z * z;
        const bool level = z == 0;
        const bool vertical = x == 0 && y == 0;
        n.is_face[i] = lattice == Lattice::cubic ? steps == 1 : level || vertical;
        n.is_edge[i] = lattice == Lattice::cubic && steps == 2;
        if (n.is_face[i]) ++n.faces;
        n.index_by_box[static_cast<std::size_t>((z + 1) * 9 + (y + 1) * 3 + (x + 1))] =
            static_cast<std::int8_t>(n.size++);
      }
    }
    if (z == 1) n.cells_above = n.size;
  }
  return n;
}

constexpr Neighbourhood kCubic = make(Lattice::cubic);
constexpr Neighbourhood kHexagonal = make(Lattice::hexagonal);
static_assert(kCubic.size == 26 && kCubic.faces == 6);
static_assert(kHexagonal.size == 20 && kHexagonal.faces == 8);

}  // namespace

const Neighbourhood& neighbourhood(Lattice lattice) {
  return lattice == Lattice::cubic ? kCubic : kHexagonal;
}

/// Cells are one wide and one high on both lattices; see the header for the frame.
Point embed(Lattice lattice, Cell cell) {
  if (lattice == Lattice::cubic) {
    return {static_cast<double>(cell.x), static_cast<double>(cell.y), static_cast<double>(cell.z)};
  }
  constexpr double kRowHeight = 0.86602540378443864676;  // √3/2
  return {cell.x + 0.5 * cell.y, kRowHeight * cell.y, static_cast<double>(cell.z)};
}

std::string_view to_string(Lattice lattice) {
  return lattice == Lattice::cubic ? "cubic" : "hexagonal";
}

}  // namespace stig::rules
