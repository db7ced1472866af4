// SPDX-License-Identifier: MIT
#include "lattice/measures.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <unordered_map>

#include "base/hash.h"

namespace stig {
namespace {

constexpr std::int64_t kMostCavityCells = std::int64_t{1} << 31;

struct CellHash {
  std::size_t operator()(Cell c) const { return placement_hash(c, 1); }
};

std::vector<Offset> faces(Lattice lattice) {
  const Neighbourhood& n = neighbourhood(lattice);
  std::vector<Offset> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    if (n.is_face[i]) all.push_back(n.offsets[i]);
  }
  return all;
}

/// Components and mean degree of the contact graph of bricks.
void measure_contacts(const Structure& structure, const std::vector<PlacedBrick>& bricks,
                      Measures& out) {
  std::unordered_map<Cell, std::size_t, CellHash> number;
  number.reserve(bricks.size());
  for (std::size_t i = 0; i < bricks.size(); ++i) number.emplace(bricks[i].at, i);
  std::vector<std::size_t> rank(bricks.size()), parent(bricks.size());
  boost::disjoint_sets sets(rank.data(), parent.data());
  for (std::size_t i = 0; i < bricks.size(); ++i) sets.make_set(i);
  std::uint64_t contacts = 0;
  std::uint64_t components = bricks.size();
  for (const Offset o : faces(structure.lattice())) {
    if (o < Offset{}) continue;  // each pair once
    for (std::size_t i = 0; i < bricks.size(); ++i) {
      const auto other = number.find(bricks[i].at + o);
      if (other == number.end()) continue;
      ++contacts;
      const std::size_t a = sets.find_set(i), b = sets.find_set(other->second);
      if (a == b) continue;
      sets.link(a, b);
      --components;
    }
  }
  out.components = components;
  out.mean_neighbours =
      bricks.empty() ? 0 : 2.0 * static_cast<double>(contacts) / static_cast<double>(bricks.size());
}

/// Floods the empty cells of the bounding box, padded by one all round, from outside;
/// what is then still dry is a cavity.
class CavityFlood {
 public:
  CavityFlood(const Structure& structure, Bounds bounds)
      : low_(bounds.low - Offset{1, 1, 1}),
        size_(bounds.size() + Offset{2, 2, 2}),
        faces_(faces(structure.lattice())),
        taken_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
               static_cast<std::size_t>(size_.z)) {
    structure.for_each([&](Cell cell, Colour) { taken_[index(cell)] = true; });
  }

  void run(Measures& out) {
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
    const Offset o = c - low_;
    return (static_cast<std::size_t>(o.z) * static_cast<std::size_t>(size_.y) +
            static_cast<std::size_t>(o.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(o.x);
  }
  bool inside(Cell c) const {
    const Offset o = c - low_;
    return o.x >= 0 && o.x < size_.x && o.y >= 0 && o.y < size_.y && o.z >= 0 && o.z < size_.z;
  }
  /// Takes the empty cells connected with `from`; returns their number.
  std::uint64_t flood(Cell from) {
    std::uint64_t number = 0;
    std::vector<Cell> open{from};
    taken_[index(from)] = true;
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      ++number;
      for (const Offset o : faces_) {
        const Cell next = cell + o;
        if (!inside(next) || taken_[index(next)]) continue;
        taken_[index(next)] = true;
        open.push_back(next);
      }
    }
    return number;
  }

  Cell low_;
  Offset size_;
  std::vector<Offset> faces_;
  std::vector<bool> taken_;
};

int symmetry_order(const Structure& structure) {
  const std::uint64_t own = structure_hash(structure);
  int order = 0;
  for (const Orientation& g :
       orientations(structure.lattice(), Symmetry::rotations_mirrors, true)) {
    if (g.name == "0°") {
      ++order;
      continue;
    }
    // Hashes part the unequal ones cheaply; equality is then certain.
    const Structure image = transformed(structure, g);
    if (structure_hash(image) == own && to_origin(image) == to_origin(structure)) ++order;
  }
  return order;
}

}  // namespace

Measures measure(const Structure& structure) {
  Measures m;
  m.bounds = structure.bounds();
  if (!m.bounds) return m;
  const std::vector<PlacedBrick> bricks = structure.bricks();
  m.height_profile.resize(static_cast<std::size_t>(m.bounds->size().z));
  for (const PlacedBrick& b : bricks) {
    if (b.brick > m.bricks_by_colour.size()) m.bricks_by_colour.resize(b.brick);
    ++m.bricks_by_colour[b.brick - 1U];
    ++m.height_profile[static_cast<std::size_t>(b.at.z - m.bounds->low.z)];
  }
  measure_contacts(structure, bricks, m);
  m.symmetry_order = symmetry_order(structure);

  const Offset size = m.bounds->size();
  const std::int64_t slice = (std::int64_t{size.x} + 2) * (std::int64_t{size.y} + 2);
  m.cavities_known =
      slice <= kMostCavityCells && slice * (std::int64_t{size.z} + 2) <= kMostCavityCells;
  if (m.cavities_known) CavityFlood(structure, *m.bounds).run(m);
  return m;
}

}  // namespace stig
