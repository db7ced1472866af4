// SPDX-License-Identifier: MIT
#include "compiler/target_bricks.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "base/hash.h"

namespace stig {

bool BrickSet::contains(const BrickSet& other) const {
  assert(words_.size() == other.words_.size());
  std::uint64_t missing = 0;
  for (std::size_t i = 0; i < words_.size(); ++i) missing |= other.words_[i] & ~words_[i];
  return missing == 0;
}

void BrickSet::add(const BrickSet& others) {
  assert(words_.size() == others.words_.size());
  for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= others.words_[i];
}

bool BrickSet::meets(const BrickSet& other) const {
  assert(words_.size() == other.words_.size());
  std::uint64_t both = 0;
  for (std::size_t i = 0; i < words_.size(); ++i) both |= words_[i] & other.words_[i];
  return both != 0;
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

/// States on the way differ in few bricks; the lowest difference is the brick that was
/// added, when it is one.
std::uint32_t brick_added(const BrickSet& before, const BrickSet& after, std::size_t bricks) {
  std::uint32_t i = 0;
  while (i < bricks && before.has(i) == after.has(i)) ++i;
  assert(i < bricks);
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
}

BrickSet TargetBricks::start() const {
  BrickSet out(bricks());
  for (std::size_t i = 0; i < start_; ++i) out.add(i);
  return out;
}

BrickSet TargetBricks::others(const BrickSet& set) const {
  BrickSet out(bricks());
  for (std::size_t i = 0; i < bricks(); ++i) {
    if (!set.has(i)) out.add(i);
  }
  return out;
}

BrickSet TargetBricks::whole() const {
  BrickSet out(bricks());
  for (std::size_t i = 0; i < bricks(); ++i) out.add(i);
  return out;
}

}  // namespace stig
