// SPDX-License-Identifier: MIT
// Orbits of the target's cells under the group about the start, and one site of each orbit
// with what is around it. All later work is done per orbit: it divides the work by the
// order of the group, and guarantees that rules and colours have the symmetry.
#include "synthesis/frame.h"

#include <algorithm>
#include <cassert>

namespace stig::synthesis {
namespace {

/// Turns about the middle of the start. Coordinates are doubled, since the middle may
/// lie between cells.
class Turning {
 public:
  explicit Turning(const std::vector<Cell>& start) {
    Cell low = start.front(), high = start.front();
    for (const Cell c : start) {
      low = {std::min(low.x, c.x), std::min(low.y, c.y), 0};
      high = {std::max(high.x, c.x), std::max(high.y, c.y), 0};
    }
    middle_ = {low.x + high.x, low.y + high.y, 0};
  }

  /// Nothing when the image lies between cells.
  std::optional<Cell> image(const Orientation& g, Cell cell) const {
    const Offset turned =
        g.apply({2 * cell.x - middle_.x, 2 * cell.y - middle_.y, cell.z}) + middle_;
    if ((turned.x & 1) != 0 || (turned.y & 1) != 0) return std::nullopt;
    return Cell{turned.x / 2, turned.y / 2, cell.z};
  }

 private:
  Offset middle_;
};

/// Every empty cell that a cell of the target is a neighbour of, sorted. Rules can fire at
/// empty cells beside the target only: an event needs a brick beside its site.
std::vector<Cell> border_of(const Frame& frame) {
  const Neighbourhood& n = frame.neighbours();
  std::vector<Cell> border;
  for (const Cell cell : frame.cells) {
    for (int i = 0; i < n.size; ++i) {
      const Cell beside = cell + n.offsets[static_cast<std::size_t>(i)];
      if (frame.floor && beside.z < 0) continue;
      if (index_in(frame.cells, beside) < 0) border.push_back(beside);
    }
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

Site site_at(const Frame& frame, Cell at, int orbit) {
  const Neighbourhood& n = frame.neighbours();
  Site site;
  site.at = at;
  site.orbit = orbit;
  site.on_floor = frame.floor && at.z == 0;
  site.beside.fill(-1);
  for (int i = 0; i < n.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int cell = index_in(frame.cells, at + n.offsets[k]);
    if (cell < 0) continue;
    site.beside[k] = frame.orbit_of[static_cast<std::size_t>(cell)];
    site.present |= 1U << i;
  }
  return site;
}

void add_orbits(const Target& target, const Placing& placing, const Turning& turning,
                Frame& frame) {
  frame.orbit_of.assign(frame.cells.size(), -1);
  for (std::size_t i = 0; i < frame.cells.size(); ++i) {
    if (frame.orbit_of[i] >= 0) continue;
    Orbit orbit;
    orbit.at = frame.cells[i];
    orbit.colours = StateSet::anything();
    const int number = static_cast<int>(frame.orbits.size());
    for (const Orientation& g : frame.group) {
      const int image = index_in(frame.cells, *turning.image(g, orbit.at));
      assert(image >= 0);
      int& of = frame.orbit_of[static_cast<std::size_t>(image)];
      if (of < 0) ++orbit.cells;
      of = number;
      orbit.colours = orbit.colours & target.colours[static_cast<std::size_t>(image)];
    }
    orbit.start =
        std::find(placing.start.begin(), placing.start.end(), orbit.at) != placing.start.end();
    frame.orbits.push_back(orbit);
  }
}

}  // namespace

/// Bisection: cells are sorted, and a hash table would take more memory than it saves time
/// here.
int index_in(const std::vector<Cell>& cells, Cell cell) {
  const auto at = std::lower_bound(cells.begin(), cells.end(), cell);
  return at == cells.end() || *at != cell ? -1 : static_cast<int>(at - cells.begin());
}

std::optional<Asymmetry> find_asymmetry(const Target& target, const Placing& placing) {
  const Turning turning(placing.start);
  for (const Orientation& g : orientations(target.lattice, placing.symmetry, false)) {
    for (std::size_t i = 0; i < target.cells.size(); ++i) {
      const Cell cell = target.cells[i];
      const std::optional<Cell> image = turning.image(g, cell);
      const int there = image ? index_in(target.cells, *image) : -1;
      if (there < 0) return Asymmetry{cell, image, g.name, false};
      if ((target.colours[i] & target.colours[static_cast<std::size_t>(there)]).none()) {
        return Asymmetry{cell, image, g.name, true};
      }
    }
  }
  return std::nullopt;
}

Frame make_frame(const Target& target, const Placing& placing) {
  assert(!placing.start.empty());
  Frame frame;
  frame.lattice = target.lattice;
  frame.symmetry = placing.symmetry;
  frame.floor = placing.floor;
  frame.group = orientations(target.lattice, placing.symmetry, false);
  frame.cells = target.cells;
  const Turning turning(placing.start);
  add_orbits(target, placing, turning, frame);
  for (std::size_t i = 0; i < frame.orbits.size(); ++i) {
    frame.sites.push_back(site_at(frame, frame.orbits[i].at, static_cast<int>(i)));
  }
  std::vector<Cell> border = border_of(frame);
  std::vector<bool> seen(border.size(), false);
  // Border cells are visited in sorted order and each marks its images, so every orbit is
  // represented by its least cell.
  for (std::size_t i = 0; i < border.size(); ++i) {
    if (seen[i]) continue;
    for (const Orientation& g : frame.group) {
      seen[static_cast<std::size_t>(index_in(border, *turning.image(g, border[i])))] = true;
    }
    frame.sites.push_back(site_at(frame, border[i], -1));
  }
  return frame;
}

}  // namespace stig::synthesis
