// SPDX-License-Identifier: MIT
// Measures of shape, each by its textbook definition (measures.h). All are O(n log n) in
// the bricks but for cavities, which need the bounding box as a bit field and are left out
// for large ones, and the symmetry order, which compares up to 24 images.
#include "lattice/measures.h"

#include <algorithm>
#include <cassert>

#include "base/islands.h"

namespace stig::lattice {
namespace {

constexpr std::int64_t kMostCavityCells = std::int64_t{1} << 26;

std::vector<Offset> faces(Lattice lattice) {
  const Neighbourhood& n = neighbourhood(lattice);
  std::vector<Offset> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    if (n.is_face[i]) all.push_back(n.offsets[i]);
  }
  return all;
}

/// Calls visit(i, k) for the pairs of bricks with bricks[k] = bricks[i] + o. Bricks are
/// in cell order, which adding an offset keeps: one sweep finds them all.
template <class Visit>
void for_each_pair(const std::vector<PlacedBrick>& bricks, Offset o, const Visit& visit) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    const Cell wanted = bricks[i].at + o;
    while (k < bricks.size() && bricks[k].at < wanted) ++k;
    if (k == bricks.size()) return;
    if (bricks[k].at == wanted) visit(i, k);
  }
}

/// Components and mean degree of the contact graph of bricks.
void measure_contacts(const Structure& structure, const std::vector<PlacedBrick>& bricks,
                      Measures& out) {
  Islands islands(bricks.size());
  std::uint64_t contacts = 0;
  std::uint64_t components = bricks.size();
  for (const Offset o : faces(structure.lattice())) {
    if (o < Offset{}) continue;  // each pair once
    for_each_pair(bricks, o, [&](std::size_t i, std::size_t k) {
      ++contacts;
      const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>(k);
      if (islands.root(a) == islands.root(b)) return;
      islands.join(a, b);
      --components;
    });
  }
  out.components = components;
  out.mean_neighbours =
      bricks.empty() ? 0 : 2.0 * static_cast<double>(contacts) / static_cast<double>(bricks.size());
}

/// Floods the empty cells of the bounding box, padded by one all round, from outside;
/// what is then still dry is a cavity.
class CavityFlood {
 public:
  CavityFlood(const Structure& structure, CellBounds bounds)
      : low_(bounds.low - Offset{1, 1, 1}),
        size_(bounds.size() + Offset{2, 2, 2}),
        faces_(faces(structure.lattice())),
        taken_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
               static_cast<std::size_t>(size_.z)) {
    // Bricks are walls of the flood, like cells that have been visited.
    structure.for_each([&](Cell cell, Colour) { taken_[index(cell)] = true; });
  }

  void run(Measures& out) {
    // The corner of the padding is outside by construction.
    flood(low_);
    for (std::int32_t z = 0; z < size_.z; ++z) {
      for (std::int32_t y = 0; y < size_.y; ++y) {
        for (std::int32_t x = 0; x < size_.x; ++x) {
          const Cell cell = low_ + Offset{x, y, z};
          if (taken_[index(cell)]) continue;
          ++out.cavities;
          out.cavity_cells += flood(cell);
        }
      }
    }
  }

 private:
  std::size_t index(Cell c) const {
    assert(inside(c));
    const Offset o = c - low_;
    return (static_cast<std::size_t>(o.z) * static_cast<std::size_t>(size_.y) +
            static_cast<std::size_t>(o.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(o.x);
  }
  Cell cell_at(std::uint32_t index) const {
    const auto i = static_cast<std::int32_t>(index);
    return low_ + Offset{i % size_.x, i / size_.x % size_.y, i / size_.x / size_.y};
  }
  bool inside(Cell c) const {
    const Offset o = c - low_;
    return o.x >= 0 && o.x < size_.x && o.y >= 0 && o.y < size_.y && o.z >= 0 && o.z < size_.z;
  }
  /// Takes the empty cells connected with `from`; returns their number.
  std::uint64_t flood(Cell from) {
    std::uint64_t number = 0;
    // Indices of 32 bits suffice, as the box has at most 2^26 cells.
    std::vector<std::uint32_t> open{static_cast<std::uint32_t>(index(from))};
    taken_[index(from)] = true;
    while (!open.empty()) {
      const Cell cell = cell_at(open.back());
      open.pop_back();
      ++number;
      for (const Offset o : faces_) {
        const Cell next = cell + o;
        if (!inside(next) || taken_[index(next)]) continue;
        taken_[index(next)] = true;
        open.push_back(static_cast<std::uint32_t>(index(next)));
      }
    }
    return number;
  }

  Cell low_;
  Offset size_;
  std::vector<Offset> faces_;
  std::vector<bool> taken_;
};

Cell image(const Orientation& g, Cell cell) { return Cell{} + g.apply(cell - Cell{}); }

/// CellBounds of the bricks' image under g.
CellBounds image_bounds(const std::vector<PlacedBrick>& bricks, const Orientation& g) {
  assert(!bricks.empty());
  CellBounds bounds{image(g, bricks.front().at), image(g, bricks.front().at)};
  auto& [low, high] = bounds;
  for (const PlacedBrick& b : bricks) {
    const Cell at = image(g, b.at);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  return bounds;
}

/// Sum of the placements' hashes in the image, with its lowest corner at the origin.
std::uint64_t image_hash(const std::vector<PlacedBrick>& bricks, const Orientation& g, Cell low) {
  std::uint64_t sum = 0;
  for (const PlacedBrick& b : bricks) {
    sum += placement_hash(Cell{} + (image(g, b.at) - low), b.brick);
  }
  return sum;
}

int symmetry_order(const Structure& structure, const std::vector<PlacedBrick>& bricks) {
  const auto group = orientations(structure.lattice(), Symmetry::rotations_mirrors, true);
  // Group element 0 is the identity, which always maps the structure onto itself.
  const std::uint64_t own = image_hash(bricks, group.front(), structure.bounds()->low);
  int order = 1;
  for (std::size_t g = 1; g < group.size(); ++g) {
    // Sizes and hashes part the unequal ones cheaply; equality is then certain.
    const CellBounds bounds = image_bounds(bricks, group[g]);
    if (bounds.size() != structure.bounds()->size()) continue;
    if (image_hash(bricks, group[g], bounds.low) != own) continue;
    if (to_origin(transformed(structure, group[g])) == to_origin(structure)) ++order;
  }
  return order;
}

}  // namespace

Measures measure(const Structure& structure) {
  Measures m;
  m.bounds = structure.bounds();
  if (!m.bounds) return m;
  const std::vector<PlacedBrick> bricks = structure.bricks();
  // The profile counts from the lowest brick and not from the floor.
  m.height_profile.resize(static_cast<std::size_t>(m.bounds->size().z));
  for (const PlacedBrick& b : bricks) {
    if (b.brick > m.bricks_by_colour.size()) m.bricks_by_colour.resize(b.brick);
    ++m.bricks_by_colour[b.brick - 1U];
    ++m.height_profile[static_cast<std::size_t>(b.at.z - m.bounds->low.z)];
  }
  measure_contacts(structure, bricks, m);
  m.symmetry_order = symmetry_order(structure, bricks);

  const Offset size = m.bounds->size();
  // The product is taken in two steps so that it cannot overflow.
  const std::int64_t slice = (std::int64_t{size.x} + 2) * (std::int64_t{size.y} + 2);
  m.cavities_known =
      slice <= kMostCavityCells && slice * (std::int64_t{size.z} + 2) <= kMostCavityCells;
  if (m.cavities_known) CavityFlood(structure, *m.bounds).run(m);
  return m;
}

}  // namespace stig::lattice
