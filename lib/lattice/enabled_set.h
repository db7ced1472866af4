// SPDX-License-Identifier: MIT
// A set of cells from which a uniformly random one can be taken: a dense list for
// sampling and an open-addressing index for membership. The order of the list
// depends only on the history of insertions and removals.
#pragma once

#include <cstdint>
#include <vector>

#include "rules/cell.h"

namespace stig {

class EnabledSet {
 public:
  EnabledSet();

  std::size_t size() const { return cells_.size(); }
  Cell operator[](std::size_t i) const { return cells_[i]; }
  void clear();
  void insert(Cell cell);  ///< no effect when present
  void erase(Cell cell);   ///< no effect when absent

 private:
  std::size_t find(Cell cell) const;  ///< its slot, or the free slot where it would go
  void grow();
  void free_slot(std::size_t slot);

  std::vector<Cell> cells_;
  std::vector<std::uint32_t> slots_;  ///< 1 + position in cells_; 0 free
};

}  // namespace stig
