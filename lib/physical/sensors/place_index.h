// SPDX-License-Identifier: MIT
// What lies about a place: boxes along the axes in the cells of a 2-D grid (structures are
// wide rather than high), made anew each tick. A question costs what it finds and the rows
// of cells that it crosses.
#pragma once

#include <cstdint>
#include <vector>

#include "physical/collision/broad_phase.h"
#include "physical/sensors/uses.h"

namespace stig::physics {

/// About a box of half edges `half` at a pose.
Bounds bounds_of(const Pose& X_WS, const Vec3& half);
Bounds bounds_of(const std::vector<Vec3>& points);

class PlaceIndex {
 public:
  PlaceIndex() = default;
  /// `cell` in m, about the size of a typical thing.
  PlaceIndex(std::vector<Bounds> bounds, double cell);

  /// The things whose bounds overlap `where`, in rising order, each once; `found` is emptied
  /// first.
  void find(const Bounds& where, std::vector<std::uint32_t>& found) const;
  const Bounds& bounds(std::uint32_t i) const { return bounds_[i]; }

 private:
  struct Entry {
    std::int64_t cell;  ///< row by row
    std::uint32_t thing;
  };

  void find_in_row(std::int32_t y, std::int32_t x0, std::int32_t x1, const Bounds& where,
                   std::vector<std::uint32_t>& found) const;

  double cell_ = 1;
  std::vector<Bounds> bounds_;
  std::vector<Entry> entries_;        ///< sorted
  std::vector<std::uint32_t> large_;  ///< in so many cells that they are asked each time
};

}  // namespace stig::physics
