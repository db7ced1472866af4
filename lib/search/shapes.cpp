// SPDX-License-Identifier: MIT
#include "search/shapes.h"

#include <algorithm>
#include <array>

#include "base/hash.h"
#include "lattice/structure.h"

namespace stig::search {
namespace {

/// Made once: orientations have names, which take longer to make than a candidate may take in all.
const std::vector<Orientation>& images_of(Lattice lattice) {
  static const std::array kGroups = {
      rules::orientations(Lattice::cubic, Symmetry::rotations_mirrors, false),
      rules::orientations(Lattice::hexagonal, Symmetry::rotations_mirrors, false)};
  return kGroups[static_cast<std::size_t>(lattice)];
}

Cell image(const Orientation& g, Cell cell) { return Cell{} + g.apply(cell - Cell{}); }

std::uint64_t image_hash(const Orientation& g, const std::vector<PlacedBrick>& bricks) {
  Cell low = image(g, bricks.front().at);
  for (const PlacedBrick& b : bricks) {
    const Cell at = image(g, b.at);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
  }
  std::uint64_t sum = 0;
  for (const PlacedBrick& b : bricks) {
    sum += placement_hash(Cell{} + (image(g, b.at) - low), b.brick);
  }
  return sum;
}

/// The cells of a structure in its bounding box, for fast looks.
class FilledCells {
 public:
  explicit FilledCells(const std::vector<PlacedBrick>& bricks) : low_(bricks.front().at) {
    Cell high = low_;
    for (const PlacedBrick& b : bricks) {
      low_ = {std::min(low_.x, b.at.x), std::min(low_.y, b.at.y), std::min(low_.z, b.at.z)};
      high = {std::max(high.x, b.at.x), std::max(high.y, b.at.y), std::max(high.z, b.at.z)};
    }
    size_ = high - low_ + Offset{1, 1, 1};
    filled_.resize(static_cast<std::size_t>(size_.x * size_.y * size_.z), false);
    for (const PlacedBrick& b : bricks) filled_[index_of(b.at - low_)] = true;
  }
  bool has(Cell cell) const {
    const Offset at = cell - low_;
    if (std::min({at.x, at.y, at.z}) < 0) return false;
    if (at.x >= size_.x || at.y >= size_.y || at.z >= size_.z) return false;
    return filled_[index_of(at)];
  }

 private:
  std::size_t index_of(Offset at) const {
    return static_cast<std::size_t>((at.z * size_.y + at.y) * size_.x + at.x);
  }
  Cell low_;
  Offset size_{};
  std::vector<bool> filled_;
};

}  // namespace

std::uint64_t shape_hash(Lattice lattice, const std::vector<PlacedBrick>& bricks) {
  std::uint64_t least = ~std::uint64_t{0};
  if (bricks.empty()) return combine(static_cast<std::uint64_t>(lattice), least);
  for (const Orientation& g : images_of(lattice)) {
    least = std::min(least, image_hash(g, bricks));
  }
  return combine(static_cast<std::uint64_t>(lattice), least);
}

double shape_distance(Lattice lattice, const std::vector<PlacedBrick>& bricks,
                      const std::vector<Cell>& target) {
  if (target.empty()) return 1;
  const FilledCells filled(bricks);
  std::size_t most = 0;
  std::vector<Cell> turned(target.size());
  for (const Orientation& g : images_of(lattice)) {
    std::transform(target.begin(), target.end(), turned.begin(),
                   [&](Cell cell) { return image(g, cell); });
    for (const Cell start : turned) {
      const auto common = std::count_if(turned.begin(), turned.end(), [&](Cell cell) {
        return filled.has(Cell{} + (cell - start));
      });
      most = std::max(most, static_cast<std::size_t>(common));
    }
  }
  const std::size_t either = bricks.size() + target.size() - most;
  return 1 - static_cast<double>(most) / static_cast<double>(either);
}

}  // namespace stig::search
