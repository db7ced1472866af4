// SPDX-License-Identifier: MIT
// What may be filled in wherever certain neighbours are there. A corner between two bricks, the
// cell above a brick up to some height: of a solid most cells can be placed by a few such
// conditions, whatever the colours of the bricks around them, and no colour is spent on them.
//
// A fill is safe when no empty place beside the whole target meets its condition. Conditions
// ask only that something is there, so no part of the target meets them at such a place either.
#pragma once

#include <limits>

#include "synthesis/effort.h"
#include "synthesis/solid_grid.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// A site from height `low` to `high` that has bricks at all of `needs`, neighbours by bit.
struct Fill {
  std::uint32_t needs = 0;
  std::int32_t low = std::numeric_limits<std::int32_t>::min();
  std::int32_t high = std::numeric_limits<std::int32_t>::max();

  bool holds(std::uint32_t there, std::int32_t height) const {
    return (there & needs) == needs && height >= low && height <= high;
  }
  bool operator==(const Fill&) const = default;
};

/// Every safe fill of so many needs, those left out that say no more than one of fewer needs;
/// the plainest first.
std::vector<Fill> safe_fills(const SolidGrid& grid, int most_needs, const Allowance& allowance);

/// Growth by fills: what follows from what was placed.
class FilledGrid {
 public:
  /// Both must outlive this. Nothing is ever placed at `never`, if that is a place.
  FilledGrid(const SolidGrid& grid, const std::vector<Fill>& fills, std::int32_t never = -1);

  /// Places a brick, and all that follows.
  void place(std::int32_t at);
  bool has(std::int32_t at) const { return placed_[static_cast<std::size_t>(at)] != 0; }
  std::uint32_t beside(std::int32_t at) const { return beside_[static_cast<std::size_t>(at)]; }
  std::size_t count() const { return count_; }

 private:
  void add(std::int32_t at);

  const SolidGrid* grid_;
  const std::vector<Fill>* fills_;
  std::int32_t never_;
  std::vector<std::vector<std::uint32_t>> by_need_;  ///< by neighbour: fills that need it
  std::vector<std::uint8_t> placed_;
  std::vector<std::uint32_t> beside_;
  std::vector<std::int32_t> open_;
  std::size_t count_ = 0;
};

}  // namespace stig::synthesis
