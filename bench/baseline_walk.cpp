// SPDX-License-Identifier: MIT
#include "baseline_walk.h"

#include <bit>

#include "rules/rule_table.h"

namespace stig::bench {
namespace {

constexpr std::uint8_t kAgent = 0x40, kSide = 0x80, kState = 0x3f;

std::uint64_t fold(std::uint64_t hash, std::uint8_t state) {
  return (hash ^ state) * 0x100000001b3ULL;
}
constexpr std::uint64_t kSeed = 0xcbf29ce484222325ULL;

}  // namespace

BaselineWalk::BaselineWalk(const RuleSet& rules, const Box& box, int agents, std::uint64_t seed)
    : word_(seed * 2 + 1) {
  const Neighbourhood& n = neighbourhood(rules.lattice);
  const std::int32_t row = box.size.x + 2, slice = row * (box.size.y + 2);
  cells_.assign(static_cast<std::size_t>(slice) * static_cast<std::size_t>(box.size.z + 2), kSide);
  const auto index = [&](Cell c) {
    const Offset o = c - box.low + Offset{1, 1, 1};
    return static_cast<std::size_t>(o.z * slice + o.y * row + o.x);
  };
  for (std::int32_t z = 0; z < box.size.z; ++z) {
    for (std::int32_t y = 0; y < box.size.y; ++y) {
      for (std::int32_t x = 0; x < box.size.x; ++x) cells_[index(box.low + Offset{x, y, z})] = 0;
    }
  }
  for (const PlacedBrick& b : rules.start) cells_[index(b.at)] = b.brick;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    steps_.push_back(n.offsets[i].z * slice + n.offsets[i].y * row + n.offsets[i].x);
  }
  const RuleTable table(rules);
  table_.resize(std::bit_ceil(table.entries().size() * 4));
  for (const Entry& entry : table.entries()) {
    std::uint64_t hash = kSeed;
    for (std::size_t i = 0; i < steps_.size(); ++i) hash = fold(hash, entry.pattern.allowed[i].first());
    std::size_t slot = hash >> 20 & (table_.size() - 1);
    while (table_[slot].colour != 0) slot = (slot + 1) & (table_.size() - 1);
    table_[slot] = {hash, table.place(entry.source.rule)};
  }
  while (agents_.size() < static_cast<std::size_t>(agents)) {
    const std::size_t cell = random() % cells_.size();
    if (cells_[cell] != 0) continue;
    cells_[cell] = kAgent;
    agents_.push_back(cell);
  }
}

std::uint64_t BaselineWalk::hash_around(std::size_t cell) const {
  std::uint64_t hash = kSeed;
  for (const std::ptrdiff_t step : steps_) {
    hash = fold(hash, cells_[cell + static_cast<std::size_t>(step)] & kState);
  }
  return hash;
}

void BaselineWalk::step() {
  for (std::size_t& agent : agents_) {
    if ((cells_[agent] & kState) == 0) {
      const std::uint64_t hash = hash_around(agent);
      for (std::size_t slot = hash >> 20 & (table_.size() - 1); table_[slot].colour != 0;
           slot = (slot + 1) & (table_.size() - 1)) {
        if (table_[slot].hash != hash) continue;
        cells_[agent] |= table_[slot].colour;
        ++deposits_;
        break;
      }
    }
    const auto pick = static_cast<std::size_t>((random() >> 32) * steps_.size() >> 32);
    const std::size_t to = agent + static_cast<std::size_t>(steps_[pick]);
    if (cells_[to] != 0) continue;
    cells_[agent] &= static_cast<std::uint8_t>(~kAgent);
    cells_[to] = kAgent;
    agent = to;
  }
}

}  // namespace stig::bench
