// SPDX-License-Identifier: MIT
// A dense box around the target with a margin, so that neighbours are fixed steps in an
// index and need no test of bounds. Dense is right here: fills and rays touch all cells of
// a solid many times. The limit keeps a grid within some tens of megabytes.
#include "synthesis/solid_grid.h"

#include <algorithm>
#include <cassert>

namespace stig::synthesis {
namespace {

constexpr std::int64_t kMostPlaces = std::int64_t{1} << 22;
/// Cells around the target: its sites are one away, and what they see is two away.
constexpr std::int32_t kMargin = 2;

void lay_box(const Target& target, SolidGrid& grid) {
  Cell low = target.cells.front(), high = low;
  for (const Cell c : target.cells) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
  }
  grid.low = low - Offset{kMargin, kMargin, kMargin};
  grid.size = (high - low) + Offset{2 * kMargin + 1, 2 * kMargin + 1, 2 * kMargin + 1};
}

}  // namespace

std::uint32_t SolidGrid::solid_beside(std::int32_t place) const {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < step.size(); ++i) {
    if (is_solid(place + step[i])) mask |= 1U << i;
  }
  return mask;
}

std::optional<SolidGrid> make_solid_grid(const Target& target, bool floor) {
  assert(!target.cells.empty());
  SolidGrid grid;
  grid.lattice = target.lattice;
  lay_box(target, grid);
  if (std::int64_t{grid.size.x} * grid.size.y > kMostPlaces ||
      std::int64_t{grid.size.x} * grid.size.y * grid.size.z > kMostPlaces) {
    return std::nullopt;
  }
  const Neighbourhood& n = grid.neighbours();
  // A step is the difference of two places, the same everywhere in the box.
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    grid.step.push_back(grid.place_of(grid.low + n.offsets[i]));
  }
  grid.solid.assign(static_cast<std::size_t>(grid.size.x * grid.size.y * grid.size.z), 0);
  for (const Cell c : target.cells) {
    grid.cells.push_back(grid.place_of(c));
    grid.solid[static_cast<std::size_t>(grid.cells.back())] = 1;
  }
  std::vector<std::uint8_t> seen = grid.solid;
  for (const std::int32_t cell : grid.cells) {
    for (const std::int32_t step : grid.step) {
      std::uint8_t& known = seen[static_cast<std::size_t>(cell + step)];
      if (known == 0 && !(floor && grid.height(cell + step) < 0)) {
        grid.beside.push_back(cell + step);
      }
      known = 1;
    }
  }
  return grid;
}

}  // namespace stig::synthesis
