// SPDX-License-Identifier: MIT
#include "compiler/target_bricks.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/hash.h"

namespace stig::compiler {

bool BrickSet::contains(const BrickSet& other) const {
  assert(words_.size() == other.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if ((other.words_[i] & ~words_[i]) != 0) return false;
  }
  return true;
}

bool BrickSet::contains_but(const BrickSet& other, std::size_t brick) const {
  assert(words_.size() == other.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) {
    std::uint64_t missing = other.words_[i] & ~words_[i];
    if (i == brick / 64) missing &= ~(std::uint64_t{1} << (brick % 64));
    if (missing != 0) return false;
  }
  return true;
}

void BrickSet::add(const BrickSet& others) {
  assert(words_.size() == others.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= others.words_[i];
}

void BrickSet::remove(const BrickSet& others) {
  assert(words_.size() == others.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] &= ~others.words_[i];
}

BrickSet BrickSet::first(std::size_t bricks) {
  BrickSet out(bricks);
  for (std::uint64_t& word : out.words_) word = ~std::uint64_t{0};
  if (bricks % 64 != 0) out.words_.back() = (std::uint64_t{1} << (bricks % 64)) - 1;
  return out;
}

bool BrickSet::meets(const BrickSet& other) const {
  assert(words_.size() == other.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) {
    if ((words_[i] & other.words_[i]) != 0) return true;
  }
  return false;
}

std::size_t BrickSet::count() const {
  std::size_t out = 0;
  for (const std::uint64_t word : words_) out += static_cast<std::size_t>(std::popcount(word));
  return out;
}

/// Used as a key in hash tables; equality is decided by the words.
std::uint64_t BrickSet::hash() const {
  std::uint64_t out = 0;
  for (const std::uint64_t word : words_) out = combine(out, word);
  return out;
}

/// The lowest difference: where one placement leads from the one to the other, it is the
/// only one.
std::uint32_t brick_added(const BrickSet& before, const BrickSet& after, std::size_t bricks) {
  std::uint32_t i = 0;
  while (i < bricks && before.has(i) == after.has(i)) ++i;
  assert(i < bricks && after.has(i));
  return i;
}

/// Numbers are places in the list: the start's bricks have the lowest ones.
TargetBricks::TargetBricks(const std::vector<PlacedBrick>& bricks, std::size_t start)
    : start_(start) {
  assert(!bricks.empty());
  for (const PlacedBrick& brick : bricks) {
    numbers_[brick.at] = static_cast<std::uint32_t>(cells_.size());
    cells_.push_back(brick.at);
    colours_.push_back(brick.brick);
  }
  const auto by_level = [](const Cell& a, const Cell& b) { return a.z < b.z; };
  const auto [low, high] = std::minmax_element(cells_.begin(), cells_.end(), by_level);
  // Robots stand on the floor, which is where the lowest brick is; levels count from there.
  floor_level_ = low->z;
  levels_ = high->z - low->z + 1;
  sort_into_lines();
}

void TargetBricks::sort_into_lines() {
  Cell low = cells_.front(), high = low;
  for (const Cell& c : cells_) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y), 0};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), 0};
  }
  low_x_ = low.x;
  low_y_ = low.y;
  with_x_.resize(static_cast<std::size_t>(high.x - low.x) + 1);
  with_y_.resize(static_cast<std::size_t>(high.y - low.y) + 1);
  for (std::uint32_t i = 0; i < cells_.size(); ++i) {
    with_x_[static_cast<std::size_t>(cells_[i].x - low.x)].push_back(i);
    with_y_[static_cast<std::size_t>(cells_[i].y - low.y)].push_back(i);
  }
}

BrickSet TargetBricks::start() const {
  BrickSet out(bricks());
  for (std::size_t i = 0; i < start_; ++i) out.add(i);
  return out;
}

BrickSet TargetBricks::others(const BrickSet& set) const {
  BrickSet out = whole();
  out.remove(set);
  return out;
}

BrickSet TargetBricks::whole() const { return BrickSet::first(bricks()); }

}  // namespace stig::compiler
