// SPDX-License-Identifier: MIT
// The checker's own idea of space: box and floor, and a table of the cells it knows.
#pragma once

#include <optional>
#include <vector>

#include "certify/uses.h"
#include "rules/rule_set.h"

namespace stig::certify {

/// Where bricks can be, and which cells are the same one.
struct Space {
  std::optional<BoxSpec> box;  ///< with its origin
  bool floor = false;          ///< cells below z = 0 look like floor; boxes do not wrap in z

  /// Inside the box and not below the floor; `cell` is wrapped already.
  bool placeable(Cell cell) const;
  /// The cell inside a periodic box that stands for this one.
  Cell wrap(Cell cell) const;
  bool is_floor(Cell cell) const { return floor && cell.z < 0; }
};

/// The box with its origin: where the start's bounding box is in its middle (on z = 0 if
/// there is a floor), unless the file says another.
BoxSpec placed_box(const BoxSpec& box, const std::vector<PlacedBrick>& start, bool floor);

inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

struct KnownCell {
  Cell at;
  Colour colour = 0;               ///< 0: no brick, a site beside one
  std::uint32_t position = kNone;  ///< in the order of the present stage
};

/// Bricks and sites by their cell, numbered as they come.
class KnownCells {
 public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  KnownCell& operator[](std::uint32_t number) { return cells_[number]; }
  const KnownCell& operator[](std::uint32_t number) const { return cells_[number]; }
  /// Its number, or kNone.
  std::uint32_t find(Cell cell) const;
  std::uint32_t find_or_add(Cell cell);

 private:
  std::size_t slot_of(Cell cell) const;
  void grow();
  std::vector<KnownCell> cells_;
  std::vector<std::uint32_t> slots_;  ///< open addressing; kNone is free; half are
};

}  // namespace stig::certify
