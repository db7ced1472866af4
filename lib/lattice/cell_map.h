// SPDX-License-Identifier: MIT
// A value for every cell of the unbounded lattice, mostly a default one: chunks of
// 8×8×8 values behind a hash index. Cells beside each other are found without a new
// look into the index.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "base/hash.h"
#include "lattice/uses.h"
#include "rules/cell.h"

namespace stig::lattice {

template <class T>
class CellMap {
 public:
  explicit CellMap(T other = T{}) : other_(other), index_(64, 0) {}

  T at(Cell cell) const {
    const Chunk* chunk = find(corner(cell));
    return chunk ? chunk->values[within(cell)] : other_;
  }
  T& operator[](Cell cell) {
    const Cell low = corner(cell);
    if (const Chunk* chunk = find(low)) return const_cast<Chunk*>(chunk)->values[within(cell)];
    return add(low).values[within(cell)];
  }

 private:
  static constexpr std::int32_t kSide = 8;
  struct Chunk {
    Cell low;
    std::array<T, kSide * kSide * kSide> values;
  };

  static Cell corner(Cell c) {
    return {c.x & ~(kSide - 1), c.y & ~(kSide - 1), c.z & ~(kSide - 1)};
  }
  static std::size_t within(Cell c) {
    return static_cast<std::size_t>(((c.z & (kSide - 1)) * kSide + (c.y & (kSide - 1))) * kSide +
                                    (c.x & (kSide - 1)));
  }
  static std::size_t hash(Cell low) {
    const auto word = [](std::int32_t v) { return std::uint64_t{static_cast<std::uint32_t>(v)}; };
    return static_cast<std::size_t>(combine(word(low.x) << 32 | word(low.y), word(low.z)));
  }
  const Chunk* find(Cell low) const {
    if (last_ && last_->low == low) return last_;
    const std::size_t mask = index_.size() - 1;
    for (std::size_t slot = hash(low) & mask; index_[slot] != 0; slot = (slot + 1) & mask) {
      const Chunk& chunk = chunks_[index_[slot] - 1];
      if (chunk.low == low) return last_ = &chunk;
    }
    return nullptr;
  }
  Chunk& add(Cell low) {
    Chunk& chunk = chunks_.emplace_back();
    chunk.low = low;
    chunk.values.fill(other_);
    if (chunks_.size() * 2 > index_.size()) {
      index_.assign(index_.size() * 2, 0);
      for (std::size_t i = 0; i < chunks_.size(); ++i) insert(i);
    } else {
      insert(chunks_.size() - 1);
    }
    last_ = &chunk;
    return chunk;
  }
  void insert(std::size_t number) {
    const std::size_t mask = index_.size() - 1;
    std::size_t slot = hash(chunks_[number].low) & mask;
    while (index_[slot] != 0) slot = (slot + 1) & mask;
    index_[slot] = static_cast<std::uint32_t>(number + 1);
  }

  T other_;
  std::deque<Chunk> chunks_;             ///< stable addresses
  std::vector<std::uint32_t> index_;     ///< open addressing: 1 + position in chunks_, 0 free
  mutable const Chunk* last_ = nullptr;  ///< where the last cell was found
};

}  // namespace stig::lattice
