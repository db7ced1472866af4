// SPDX-License-Identifier: MIT
// What robots see and may do on the way, where every brick has a colour of its own.
#pragma once

#include <bitset>
#include <vector>

#include "assembly/candidate.h"
#include "assembly/uses.h"

namespace stig::assembly {

inline constexpr std::size_t kMostCells = 128;  ///< of a window
using CellBits = std::bitset<kMostCells>;

struct Choice {
  WindowCell at;
  std::uint32_t brick = 0;
};

/// An observation that can arise.
struct Case {
  ApproachSide side{};
  CellBits empty, filled;             ///< of the window, as it is seen
  std::vector<std::uint32_t> bricks;  ///< by cell: which brick is seen, where one is
  std::vector<Choice> choices;        ///< what may be done
};

/// Cases of which something has to be done in each, at one column.
using WayOn = std::vector<std::uint32_t>;

struct Cases {
  std::vector<Case> cases;
  /// In each of these, one of the ways on has to be open.
  std::vector<std::vector<WayOn>> ways_on;
};

/// Takes a candidate that was walked, and looks at it structure by structure.
Cases cases_of(const CandidateOrder& candidate);

}  // namespace stig::assembly
