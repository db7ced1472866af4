// SPDX-License-Identifier: MIT
// The cells of a solid box as an array with a margin of one cell, which no view from inside the box
// leaves, and what is known of those that a run has seen. The order of numbers is that of cells.
//
// A thread keeps the array of its last run and gives it to the next one in the same box: that is
// cleared cell by cell of those seen, which takes less than to lay out a box of which little is
// built.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lattice/box.h"
#include "lattice/uses.h"
#include "rules/standing_view.h"

namespace stig::lattice {

using CellNumber = std::uint32_t;

/// Marks of a cell.
enum : std::uint8_t {
  kSeenCell = 1,    ///< it has a record
  kClosedCell = 2,  ///< never a site: a brick, floor, outside
};

class BoxCells {
 public:
  /// Is the box solid, and not too large?
  static bool fit(const std::optional<Box>& box);
  /// For a box that fits; `floor_code`: of what lies below z = 0, unless that looks empty.
  static std::unique_ptr<BoxCells> take(const Box& box, std::optional<std::size_t> floor_code);
  /// Clears them, for the next to take.
  static void give_back(std::unique_ptr<BoxCells> cells);

  struct Record {
    std::uint64_t hash;      ///< of the view
    std::uint32_t occupied;  ///< bit i: neighbour i is not empty
    std::uint32_t place;     ///< 1 + position in a list; 0: none
  };

  std::int32_t step(Offset o) const { return o.x * slice_ + o.y * row_ + o.z; }
  CellNumber number(Cell cell) const { return static_cast<CellNumber>(step(cell - corner_)); }
  Cell cell(CellNumber number) const;
  CodedCell& operator[](CellNumber number) { return cells_[number]; }
  const CodedCell* at(CellNumber number) const { return cells_.data() + number; }
  Record& record(CellNumber number) { return records_[number]; }
  /// Stages; there with the first call of with_stages().
  std::uint64_t& stages(CellNumber number) { return stages_[number]; }
  void with_stages();

  /// Notes a brick, or another cell that is written to for the first time.
  void note(CellNumber number) { seen_.push_back(number); }
  /// All that were noted.
  const std::vector<CellNumber>& seen() const { return seen_; }
  std::vector<CellNumber>& open() { return open_; }  ///< the owner's list

 private:
  BoxCells(const Box& box, std::optional<std::size_t> floor_code);
  void clear();

  Box box_;
  std::optional<std::size_t> floor_code_;
  Cell corner_;  ///< of the margin, the lowest
  std::int32_t row_, slice_;
  std::vector<CodedCell> cells_;
  // Never written where nothing was seen.
  std::unique_ptr<Record[]> records_;
  std::unique_ptr<std::uint64_t[]> stages_;
  std::vector<CellNumber> seen_, open_;
};

}  // namespace stig::lattice
