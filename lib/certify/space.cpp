// SPDX-License-Identifier: MIT
// Box, floor and the table of known cells, written again for the checker: lib/lattice has
// its own of each, and nothing of it is trusted (docs/proofs.md). Coordinates are bounded
// by kMaxCoordinate (rules/cell.h), which keeps sums and differences of two of them within
// 32 bits.
#include "certify/space.h"

#include <algorithm>
#include <cassert>

#include "base/hash.h"

namespace stig::certify {
namespace {

bool within(std::int32_t at, std::int32_t low, std::int32_t size) {
  return at >= low && at - low < size;
}

/// C++'s remainder takes the sign of the dividend; adding the size once makes it a modulus.
std::int32_t wrapped(std::int32_t at, std::int32_t low, std::int32_t size) {
  return low + ((at - low) % size + size) % size;
}

/// The lowest coordinate of a side that has [low, high] in its middle, rounded down.
/// Division in C++ rounds towards zero; the even part of `spare` is halved exactly, so the
/// result is rounded down for a start larger than its box too. The convention is that of
/// lattice/box.h: if they differed, every certificate for a centred box would be refused.
std::int32_t centred(std::int32_t low, std::int32_t high, std::int32_t size) {
  const std::int32_t spare = size - (high - low + 1);
  return low - (spare - (spare % 2 + 2) % 2) / 2;
}

}  // namespace

bool Space::placeable(Cell cell) const {
  assert(!box || box->origin);
  if (is_floor(cell)) return false;
  return !box || (within(cell.x, box->origin->x, box->size.x) &&
                  within(cell.y, box->origin->y, box->size.y) &&
                  within(cell.z, box->origin->z, box->size.z));
}

Cell Space::wrap(Cell cell) const {
  if (!box || !box->periodic) return cell;
  // With a floor, periodic boxes wrap in x and y only: there is nothing below z = 0.
  return {wrapped(cell.x, box->origin->x, box->size.x),
          wrapped(cell.y, box->origin->y, box->size.y),
          floor ? cell.z : wrapped(cell.z, box->origin->z, box->size.z)};
}

BoxSpec placed_box(const BoxSpec& box, const std::vector<PlacedBrick>& start, bool floor) {
  if (box.origin) return box;
  Cell low = start.empty() ? Cell{} : start.front().at, high = low;
  for (const PlacedBrick& brick : start) {
    low = {std::min(low.x, brick.at.x), std::min(low.y, brick.at.y), std::min(low.z, brick.at.z)};
    high = {std::max(high.x, brick.at.x), std::max(high.y, brick.at.y),
            std::max(high.z, brick.at.z)};
  }
  BoxSpec placed = box;
  placed.origin = Cell{centred(low.x, high.x, box.size.x), centred(low.y, high.y, box.size.y),
                       floor ? 0 : centred(low.z, high.z, box.size.z)};
  return placed;
}

/// The slot that holds the cell, or the free one where it belongs. Cells of a row are kept
/// together, since they are asked for together. Open addressing with linear probing. Eight
/// neighbouring cells in x share a hash and differ in the last three bits, so the three
/// cells of a neighbourhood's row mostly share a cache line.
std::size_t KnownCells::slot_of(Cell cell) const {
  assert(std::has_single_bit(slots_.size()));
  const auto bits = [](std::int32_t n) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n));
  };
  const std::uint64_t row = mix(bits(cell.x >> 3) ^ bits(cell.y) << 22U ^ bits(cell.z) << 43U);
  std::size_t slot = (row * 8 + (bits(cell.x) & 7U)) & (slots_.size() - 1);
  while (slots_[slot] != kNone && cells_[slots_[slot]].at != cell) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  return slot;
}

std::uint32_t KnownCells::find(Cell cell) const {
  return slots_.empty() ? kNone : slots_[slot_of(cell)];
}

std::uint32_t KnownCells::find_or_add(Cell cell) {
  // At most half of the slots are taken, so probes stay short.
  if (cells_.size() * 2 >= slots_.size()) grow();
  std::uint32_t& number = slots_[slot_of(cell)];
  if (number == kNone) {
    number = size();
    cells_.push_back({cell});
  }
  return number;
}

void KnownCells::grow() {
  // Cells keep their numbers; only the slots are laid out anew.
  slots_.assign(std::max<std::size_t>(64, slots_.size() * 2), kNone);
  for (std::uint32_t i = 0; i < size(); ++i) slots_[slot_of(cells_[i].at)] = i;
}

}  // namespace stig::certify
