// SPDX-License-Identifier: MIT
// Cells with marks (64 bits each, such as stages): a dense list, from which a random
// cell can be taken, and an open-addressing index for membership. The order of the
// list depends only on the history of changes.
#pragma once

#include <cstdint>
#include <vector>

#include "lattice/uses.h"
#include "rules/cell.h"

namespace stig::lattice {

class CellMarks {
 public:
  CellMarks();

  std::size_t size() const { return entries_.size(); }
  Cell operator[](std::size_t i) const { return entries_[i].cell; }
  bool contains(Cell cell) const { return slots_[find(cell)] != 0; }
  void clear();
  /// Marks a cell anew; marks of 0 take it out. False when it was not in and stays out.
  bool set(Cell cell, std::uint64_t marks);
  /// The cells that have one of `marks`, in cell order.
  std::vector<Cell> cells_with(std::uint64_t marks) const;

 private:
  struct Entry {
    Cell cell;
    std::uint64_t marks;
  };
  std::size_t find(Cell cell) const;  ///< its slot, or the free slot where it would go
  void erase(std::size_t slot);
  void free_slot(std::size_t slot);
  void grow();

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;  ///< 1 + position in entries_; 0 free
};

}  // namespace stig::lattice
