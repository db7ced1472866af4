// SPDX-License-Identifier: MIT
// A grid as one sorted array of (cell, thing) instead of a hash table: it is made anew each tick,
// and sorting gives the same order on every machine. A row of cells is a run of the array, found by
// one binary search.
#include "physical/sensors/place_index.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace stig::physics {

namespace {

// A ramp or a wall would fill thousands of cells: such things are kept apart and asked each time.
constexpr std::int64_t kMostCells = 64;  ///< of one thing
// Below 2^31, so that the casts are defined for any finite coordinate; bodies that blew away share
// the last cell.
constexpr double kMostCoordinate = 1e9;  ///< cells beyond are the same one

std::int32_t cell_at(double v, double cell) {
  assert(!std::isnan(v));
  return static_cast<std::int32_t>(
      std::clamp(std::floor(v / cell), -kMostCoordinate, kMostCoordinate));
}

// The row in the high half, the column added with its sign: keys of one row are a run, and rows do
// not mingle since a column is below 2^31 in magnitude.
std::int64_t key(std::int32_t x, std::int32_t y) {
  return std::int64_t{y} * (std::int64_t{1} << 32) + x;
}

}  // namespace

Bounds bounds_of(const Pose& X_WS, const Vec3& half) {
  // The half extents of a turned box are |R| · half (the absolute values of R's entries).
  const Mat3 r = matrix(X_WS.q);
  const auto reach = [&](double x, double y, double z) {
    return std::abs(x) * half.x + std::abs(y) * half.y + std::abs(z) * half.z;
  };
  const Vec3 e{reach(r.x.x, r.y.x, r.z.x), reach(r.x.y, r.y.y, r.z.y), reach(r.x.z, r.y.z, r.z.z)};
  return {X_WS.p - e, X_WS.p + e};
}

Bounds bounds_of(const std::vector<Vec3>& points) {
  Bounds out{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (const Vec3& p : points) {
    out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y), std::min(out.low.z, p.z)};
    out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y), std::max(out.high.z, p.z)};
  }
  return out;
}

PlaceIndex::PlaceIndex(std::vector<Bounds> bounds, double cell)
    : cell_(cell), bounds_(std::move(bounds)) {
  assert(cell > 0);
  for (std::uint32_t i = 0; i < bounds_.size(); ++i) {
    const Bounds& b = bounds_[i];
    const std::int32_t x0 = cell_at(b.low.x, cell), x1 = cell_at(b.high.x, cell);
    const std::int32_t y0 = cell_at(b.low.y, cell), y1 = cell_at(b.high.y, cell);
    // The first test keeps the product of the second within 64 bits.
    if ((std::int64_t{x1} - x0 + 1) > kMostCells ||
        (std::int64_t{x1} - x0 + 1) * (std::int64_t{y1} - y0 + 1) > kMostCells) {
      large_.push_back(i);
      continue;
    }
    for (std::int32_t y = y0; y <= y1; ++y) {
      for (std::int32_t x = x0; x <= x1; ++x) entries_.push_back({key(x, y), i});
    }
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cell, a.thing) < std::tie(b.cell, b.thing);
  });
}

void PlaceIndex::find_in_row(std::int32_t y, std::int32_t x0, std::int32_t x1, const Bounds& where,
                             std::vector<std::uint32_t>& found) const {
  const std::int64_t last = key(x1, y);
  auto at = std::lower_bound(entries_.begin(), entries_.end(), key(x0, y),
                             [](const Entry& e, std::int64_t k) { return e.cell < k; });
  for (; at != entries_.end() && at->cell <= last; ++at) {
    if (overlap(bounds_[at->thing], where)) found.push_back(at->thing);
  }
}

void PlaceIndex::find(const Bounds& where, std::vector<std::uint32_t>& found) const {
  found.clear();
  const std::int32_t x0 = cell_at(where.low.x, cell_), x1 = cell_at(where.high.x, cell_);
  const std::int32_t y0 = cell_at(where.low.y, cell_), y1 = cell_at(where.high.y, cell_);
  // A question about a huge place, as of a camera without a near limit, would walk rows that are
  // empty: then it looks at every entry once instead.
  if (std::int64_t{y1} - y0 > static_cast<std::int64_t>(entries_.size())) {
    for (const Entry& e : entries_) {
      if (overlap(bounds_[e.thing], where)) found.push_back(e.thing);
    }
  } else {
    for (std::int32_t y = y0; y <= y1; ++y) find_in_row(y, x0, x1, where, found);
  }
  for (const std::uint32_t i : large_) {
    if (overlap(bounds_[i], where)) found.push_back(i);
  }
  std::sort(found.begin(), found.end());
  // A thing that reaches over several cells was found in each.
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace stig::physics
