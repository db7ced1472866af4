// SPDX-License-Identifier: MIT
// A hash table with linear probing over a dense list. Both are needed: engines ask for
// membership at every neighbour of a deposit, and draw a site uniformly, which takes an
// index. Deletion moves the last entry into the gap; so the order of the list, and with it
// what a random index means, is a function of the history of changes alone and not of
// addresses or of the standard library.
#include "lattice/cell_marks.h"

#include <algorithm>
#include <cassert>

#include "base/hash.h"

namespace stig::lattice {
namespace {

constexpr std::size_t kFewestSlots = 64;

/// Unsigned sums wrap, so far cells are as good as near ones.
std::size_t home(Cell c, std::size_t mask) {
  const auto word = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v));
  };
  return mix(word(c.x) + word(c.y) * 0x9e3779b97f4a7c15ULL + word(c.z) * 0xc2b2ae3d27d4eb4fULL) &
         mask;
}

}  // namespace

CellMarks::CellMarks() : slots_(kFewestSlots, 0) {}

void CellMarks::clear() {
  entries_.clear();
  slots_.assign(kFewestSlots, 0);
}

std::size_t CellMarks::find(Cell cell) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = home(cell, mask);
  while (slots_[slot] != 0 && entries_[slots_[slot] - 1].cell != cell) slot = (slot + 1) & mask;
  return slot;
}

bool CellMarks::set(Cell cell, std::uint64_t marks) {
  const std::size_t slot = find(cell);
  if (slots_[slot] == 0 && marks == 0) return false;
  if (marks == 0) {
    erase(slot);
  } else if (slots_[slot] != 0) {
    entries_[slots_[slot] - 1].marks = marks;
  } else {
    entries_.push_back({cell, marks});
    slots_[slot] = static_cast<std::uint32_t>(entries_.size());
    if (entries_.size() * 2 > slots_.size()) grow();
  }
  return true;
}

/// Constant time. References to positions in the list do not survive it.
void CellMarks::erase(std::size_t slot) {
  assert(slots_[slot] != 0);
  const std::uint32_t number = slots_[slot];
  free_slot(slot);
  if (number < entries_.size()) {  // the last entry takes its place in the list
    slots_[find(entries_.back().cell)] = number;
    entries_[number - 1] = entries_.back();
  }
  entries_.pop_back();
}

/// Frees a slot and moves later ones of its run back, so that no search breaks off.
/// Backward-shift deletion (D. Knuth, TAOCP 3, 6.4, algorithm R): no tombstones, so probes
/// stay short in tables that change all the time.
void CellMarks::free_slot(std::size_t slot) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t hole = slot;
  for (std::size_t next = (slot + 1) & mask; slots_[next] != 0; next = (next + 1) & mask) {
    const std::size_t wanted = home(entries_[slots_[next] - 1].cell, mask);
    // The entry at `next` may move into the hole if its home does not lie between hole and
    // `next`, cyclically.
    if (((next - wanted) & mask) >= ((next - hole) & mask)) {
      slots_[hole] = slots_[next];
      hole = next;
    }
  }
  slots_[hole] = 0;
}

void CellMarks::grow() {
  slots_.assign(slots_.size() * 2, 0);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    slots_[find(entries_[i].cell)] = static_cast<std::uint32_t>(i + 1);
  }
}

std::vector<Cell> CellMarks::cells_with(std::uint64_t marks) const {
  std::vector<Cell> cells;
  for (const Entry& entry : entries_) {
    if ((entry.marks & marks) != 0) cells.push_back(entry.cell);
  }
  // Sorted, as a set has no order of its own that results could depend on.
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace stig::lattice
