// SPDX-License-Identifier: MIT
// Lattice coordinates. z points up; x, y, z are right-handed. On the hexagonal
// lattice x and y are the axial coordinates q and r (see neighbourhood.h).
//
// A Cell is a place, an Offset a difference of places: Cell - Cell is an Offset,
// Cell + Offset a Cell, and nothing else is defined.
#pragma once

#include <compare>
#include <cstdint>

namespace stig::rules {

struct Offset {
  std::int32_t x = 0, y = 0, z = 0;
  auto operator<=>(const Offset&) const = default;
};

struct Cell {
  std::int32_t x = 0, y = 0, z = 0;
  /// Lexicographic in (x, y, z).
  auto operator<=>(const Cell&) const = default;
};

constexpr Offset operator+(Offset a, Offset b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Offset operator-(Offset a) { return {-a.x, -a.y, -a.z}; }
constexpr Cell operator+(Cell c, Offset o) { return {c.x + o.x, c.y + o.y, c.z + o.z}; }
constexpr Cell operator-(Cell c, Offset o) { return {c.x - o.x, c.y - o.y, c.z - o.z}; }
constexpr Offset operator-(Cell a, Cell b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Coordinates read from files and command lines stay within ±kMaxCoordinate, so
/// that sums of a few of them never overflow.
inline constexpr std::int32_t kMaxCoordinate = 1 << 24;

}  // namespace stig::rules
