// SPDX-License-Identifier: MIT
#include "baseline_walk.h"

#include <bit>
#include <cassert>
#include <cstring>

#include "rules/rule_table.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

/// The 54-bit key of an exact pattern: rows from the lowest slice up, y rising, two bits
/// a cell with x rising, the site itself 0.
std::uint64_t key_of(const Pattern& pattern, const Neighbourhood& n) {
  std::uint64_t key = 0;
  int shift = 0;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x, shift += 2) {
        const int i = n.index_of({x, y, z});
        if (i < 0) continue;
        key |= std::uint64_t{pattern.allowed[static_cast<std::size_t>(i)].first()} << shift;
      }
    }
  }
  return key;
}

}  // namespace

BaselineWalk::BaselineWalk(const RuleSet& rules, const Box& box, int agents, std::uint64_t seed)
    : row_(box.size.x + 2), slice_(row_ * (box.size.y + 2)), word_(seed * 2 + 1) {
  assert(rules.lattice == Lattice::cubic && rules.colours() <= 3 && !rules.floor);
  const Neighbourhood& n = neighbourhood(rules.lattice);
  const auto cells = static_cast<std::size_t>(slice_ * (box.size.z + 2));
  packed_.assign(cells / 4 + 16, 0);
  taken_.assign(cells, 1);
  const auto index = [&](Cell c) {
    const Offset o = c - box.low + Offset{1, 1, 1};
    return o.z * slice_ + o.y * row_ + o.x;
  };
  for (std::int32_t z = 0; z < box.size.z; ++z) {
    for (std::int32_t y = 0; y < box.size.y; ++y) {
      for (std::int32_t x = 0; x < box.size.x; ++x) {
        taken_[static_cast<std::size_t>(index(box.low + Offset{x, y, z}))] = 0;
      }
    }
  }
  for (const PlacedBrick& b : rules.start) pack(index(b.at), b.brick);
  for (std::size_t i = 0; i < static_cast<std::size_t>(n.size); ++i) {
    steps_.push_back(n.offsets[i].z * slice_ + n.offsets[i].y * row_ + n.offsets[i].x);
  }
  const RuleTable table(rules);
  table_.resize(std::bit_ceil(table.entries().size() * 4));
  for (const Entry& entry : table.entries()) {
    const std::uint64_t key = key_of(entry.pattern, n);
    std::size_t at = slot(key);
    while (table_[at].colour != 0) at = (at + 1) & (table_.size() - 1);
    table_[at] = {key, table.place(entry.source.rule)};
  }
  while (agents_.size() < static_cast<std::size_t>(agents)) {
    const std::uint64_t cell = random() % cells;
    if (taken_[cell] != 0) continue;
    taken_[cell] = 1;
    agents_.push_back(static_cast<std::int64_t>(cell));
  }
}

void BaselineWalk::pack(std::int64_t cell, Colour colour) {
  packed_[static_cast<std::size_t>(cell >> 2)] |=
      static_cast<std::uint8_t>(colour << (cell & 3) * 2);
  taken_[static_cast<std::size_t>(cell)] = 1;
}

std::uint64_t BaselineWalk::key_around(std::int64_t cell) const {
  std::uint64_t key = 0;
  int shift = 0;
  for (std::int64_t z = -1; z <= 1; ++z) {
    for (std::int64_t y = -1; y <= 1; ++y, shift += 6) {
      const std::int64_t first = cell + z * slice_ + y * row_ - 1;
      std::uint16_t word;
      std::memcpy(&word, packed_.data() + (first >> 2), sizeof word);
      key |= (std::uint64_t{word} >> (first & 3) * 2 & 63U) << shift;
    }
  }
  return key;
}

void BaselineWalk::step() {
  for (std::int64_t& agent : agents_) {
    const std::uint64_t key = key_around(agent);
    for (std::size_t at = slot(key); table_[at].colour != 0; at = (at + 1) & (table_.size() - 1)) {
      if (table_[at].key != key) continue;  // never the key of an agent inside its brick
      pack(agent, table_[at].colour);
      ++deposits_;
      break;
    }
    const std::uint64_t pick = (random() >> 32) * steps_.size() >> 32;
    const std::int64_t to = agent + steps_[pick];
    if (taken_[static_cast<std::size_t>(to)] != 0) continue;
    const bool in_brick =
        (packed_[static_cast<std::size_t>(agent >> 2)] >> (agent & 3) * 2 & 3) != 0;
    taken_[static_cast<std::size_t>(agent)] = in_brick ? 1 : 0;
    taken_[static_cast<std::size_t>(to)] = 1;
    agent = to;
  }
}

}  // namespace stig::bench
