// SPDX-License-Identifier: MIT
// The cells an agent sees around a site. This is the one place where the
// lattices' geometry is drawn; everything else asks it.
//
// Cubic: the 26 cells of the 3×3×3 box around the site. Hexagonal: 7 above, 6 on
// the level, 7 below, in axial coordinates (x = q, y = r). Both are subsets of
// the 3×3×3 box of offsets, so one world layout serves both.
//
// Index order is reading order of a drawing: slice above, level, below; rows y+1,
// y, y-1; columns x-1, x, x+1; the site itself is skipped. Cubic slices read
//
//    (-1,+1) (0,+1) (+1,+1)
//    (-1, 0) (0, 0) (+1, 0)
//    (-1,-1) (0,-1) (+1,-1)
//
// and hexagonal slices, drawn as rows of 2, 3, 2, read
//
//       (-1,+1) (0,+1)
//    (-1,0)  site  (+1,0)
//        (0,-1) (+1,-1)
//
// In the plane a hexagonal cell (q, r) has its centre at (q + r/2, r·√3/2) cell
// widths, so y still points "up the page" in a right-handed frame.
#pragma once

#include <array>
#include <string_view>

#include "rules/cell.h"
#include "rules/state.h"

namespace stig::rules {

enum class Lattice : std::uint8_t { cubic, hexagonal };

inline constexpr int kMaxNeighbours = 26;

/// What an agent sees from a site: the state of each neighbour, by index; unused
/// entries are kEmpty. 32 bytes so that views can be copied and compared whole.
struct alignas(32) View {
  std::array<State, 32> at{};
  bool operator==(const View&) const = default;
};

struct Neighbourhood {
  int size = 0;   ///< 26 or 20
  int faces = 0;  ///< 6 or 8 neighbours that share a face
  std::array<Offset, kMaxNeighbours> offsets{};
  std::array<bool, kMaxNeighbours> is_face{};  ///< shares a face with the site
  std::array<bool, kMaxNeighbours> is_edge{};  ///< cubic: shares an edge only
  std::array<std::int8_t, 27> index_by_box{};  ///< see index_of; -1: no neighbour
  int cells_above = 0;                         ///< 9 or 7; indices [0, cells_above)
  int first_below = 0;                         ///< indices [first_below, size) are below

  /// Index of an offset, or -1 when it is no neighbour (the site included).
  constexpr int index_of(Offset o) const {
    if (o.x < -1 || o.x > 1 || o.y < -1 || o.y > 1 || o.z < -1 || o.z > 1) return -1;
    return index_by_box[static_cast<std::size_t>((o.z + 1) * 9 + (o.y + 1) * 3 + (o.x + 1))];
  }
  /// Index of the neighbour on the opposite side.
  constexpr int opposite(int index) const {
    return index_of(-offsets[static_cast<std::size_t>(index)]);
  }
};

/// The neighbourhood of a lattice; the reference is to a constant table.
const Neighbourhood& neighbourhood(Lattice lattice);

/// Centre of a cell in cell widths (a block is 1 wide and 1 high on both lattices).
struct Point {
  double x = 0, y = 0, z = 0;
};
Point embed(Lattice lattice, Cell cell);

std::string_view to_string(Lattice lattice);

}  // namespace stig::rules
