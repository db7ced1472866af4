// SPDX-License-Identifier: MIT
// Which things may touch: boxes along the axes in a 2-D grid of cells, since structures are
// wide rather than high. Things at rest stand in a list of their own that is made anew only
// when one falls asleep or wakes. A thing is a body, or all bodies of a mechanism together: they
// are many, and mostly far from everything else.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace stig::physics {

struct Bounds {
  Vec3 low, high;
};
inline bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

struct CellEntry {
  std::int32_t x, y;
  std::uint32_t thing;

  friend auto operator<=>(const CellEntry&, const CellEntry&) = default;
};

/// The cells of the things listed, sorted. `bounds` is indexed by thing.
std::vector<CellEntry> cells_of(const std::vector<std::uint32_t>& things,
                                const std::vector<Bounds>& bounds, double cell);

/// Pairs a < b of things whose bounds overlap: among `moving`, and between `moving` and
/// `resting`. Sorted, each once.
std::vector<std::pair<std::uint32_t, std::uint32_t>> candidate_pairs(
    const std::vector<CellEntry>& moving, const std::vector<CellEntry>& resting,
    const std::vector<Bounds>& bounds);

}  // namespace stig::physics
