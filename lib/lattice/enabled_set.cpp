// SPDX-License-Identifier: MIT
#include "lattice/enabled_set.h"

#include "base/hash.h"

namespace stig {
namespace {

std::size_t home(Cell c, std::size_t mask) {
  const auto word = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v));
  };
  return mix(word(c.x) + word(c.y) * 0x9e3779b97f4a7c15ULL + word(c.z) * 0xc2b2ae3d27d4eb4fULL) &
         mask;
}

}  // namespace

EnabledSet::EnabledSet() : slots_(64, 0) {}

void EnabledSet::clear() {
  cells_.clear();
  slots_.assign(64, 0);
}

std::size_t EnabledSet::find(Cell cell) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = home(cell, mask);
  while (slots_[slot] != 0 && cells_[slots_[slot] - 1] != cell) slot = (slot + 1) & mask;
  return slot;
}

void EnabledSet::insert(Cell cell) {
  const std::size_t slot = find(cell);
  if (slots_[slot] != 0) return;
  cells_.push_back(cell);
  slots_[slot] = static_cast<std::uint32_t>(cells_.size());
  if (cells_.size() * 2 > slots_.size()) grow();
}

void EnabledSet::erase(Cell cell) {
  const std::size_t slot = find(cell);
  if (slots_[slot] == 0) return;
  const std::uint32_t number = slots_[slot];
  free_slot(slot);
  if (number < cells_.size()) {  // the last cell takes its place in the list
    slots_[find(cells_.back())] = number;
    cells_[number - 1] = cells_.back();
  }
  cells_.pop_back();
}

/// Frees a slot and moves later ones of its run back, so that no search breaks off.
void EnabledSet::free_slot(std::size_t slot) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t hole = slot;
  for (std::size_t next = (slot + 1) & mask; slots_[next] != 0; next = (next + 1) & mask) {
    const std::size_t wanted = home(cells_[slots_[next] - 1], mask);
    if (((next - wanted) & mask) >= ((next - hole) & mask)) {
      slots_[hole] = slots_[next];
      hole = next;
    }
  }
  slots_[hole] = 0;
}

void EnabledSet::grow() {
  slots_.assign(slots_.size() * 2, 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    slots_[find(cells_[i])] = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace stig
