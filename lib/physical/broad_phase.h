// SPDX-License-Identifier: MIT
// Which bodies may touch: boxes along the axes in a 2-D grid of cells, since structures are
// wide rather than high. Bodies at rest stand in a list of their own that is made anew only
// when one falls asleep or wakes.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace stig {

struct Bounds {
  Vec3 low, high;
};

struct CellEntry {
  std::int32_t x, y;
  std::uint32_t body;

  friend auto operator<=>(const CellEntry&, const CellEntry&) = default;
};

/// The cells of the bodies listed, sorted. `bounds` is indexed by body.
std::vector<CellEntry> cells_of(const std::vector<std::uint32_t>& bodies,
                                const std::vector<Bounds>& bounds, double cell);

/// Pairs a < b of bodies whose bounds overlap: among `moving`, and between `moving` and
/// `resting`. Sorted, each once. Bodies of one group are no pair, but for group -1; no groups
/// are given: all pairs.
std::vector<std::pair<std::uint32_t, std::uint32_t>> candidate_pairs(
    const std::vector<CellEntry>& moving, const std::vector<CellEntry>& resting,
    const std::vector<Bounds>& bounds, const std::vector<std::int32_t>& groups = {});

}  // namespace stig
