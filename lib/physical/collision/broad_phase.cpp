// SPDX-License-Identifier: MIT
// A hashed grid without a hash: entries (cell, body) in a sorted list, in which the bodies of a
// cell stand together. Sorting costs n log n, and gives an order that depends on nothing but the
// cells, as results have to be the same on every machine. Cells are columns: heights do not matter
// on a floor.
#include "physical/collision/broad_phase.h"

#include <algorithm>
#include <cassert>

namespace stig::physics {

namespace {

bool same_cell(const CellEntry& a, const CellEntry& b) { return a.x == b.x && a.y == b.y; }

}  // namespace

std::vector<CellEntry> cells_of(const std::vector<std::uint32_t>& things,
                                const std::vector<Bounds>& bounds, double cell) {
  assert(cell > 0 || things.empty());
  std::vector<CellEntry> out;
  // A body mostly lies in one to four columns.
  out.reserve(things.size() * 4);
  const auto at = [cell](double x) { return static_cast<std::int32_t>(std::floor(x / cell)); };
  for (const std::uint32_t thing : things) {
    const Bounds& box = bounds[thing];
    for (std::int32_t x = at(box.low.x); x <= at(box.high.x); ++x) {
      for (std::int32_t y = at(box.low.y); y <= at(box.high.y); ++y) out.push_back({x, y, thing});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> candidate_pairs(
    const std::vector<CellEntry>& moving, const std::vector<CellEntry>& resting,
    const std::vector<Bounds>& bounds) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  const auto consider = [&](std::uint32_t a, std::uint32_t b) {
    if (overlap(bounds[a], bounds[b])) out.push_back(std::minmax(a, b));
  };
  // Pairs within `moving`, and of moving with resting; two that rest have no pair to look at.
  for (auto a = moving.begin(); a != moving.end(); ++a) {
    for (auto b = a + 1; b != moving.end() && same_cell(*a, *b); ++b) consider(a->thing, b->thing);
    const CellEntry first{a->x, a->y, 0};
    auto b = std::lower_bound(resting.begin(), resting.end(), first);
    for (; b != resting.end() && same_cell(*a, *b); ++b) consider(a->thing, b->thing);
  }
  // Bodies that share several cells give a pair several times.
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace stig::physics
