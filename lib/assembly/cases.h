// SPDX-License-Identifier: MIT
// What robots see and may do on the way, where every brick has a colour of its own.
#pragma once

#include <bitset>
#include <vector>

#include "assembly/candidate.h"

namespace stig {

inline constexpr std::size_t kMostCells = 128;  ///< of a window
using CellBits = std::bitset<kMostCells>;

struct Choice {
  WindowCell at;
  std::uint32_t brick = 0;
};

/// An observation that can arise.
struct Case {
  ApproachSide side{};
  CellBits empty, filled;            ///< of the window, as it is seen
  std::vector<std::uint8_t> bricks;  ///< by cell: which brick is seen, where one is
  std::vector<Choice> choices;       ///< what may be done
  std::uint32_t observation = 0;
};

/// Two cases that colours alone may tell apart, if anything does.
struct Likeness {
  std::uint32_t a = 0, b = 0;
  /// Some question that `a` answers has no answer in `b`: they are told apart if nothing is to be
  /// done in `b`.
  bool unless_idle = false;
};

struct Cases {
  std::vector<Case> cases;
  std::vector<Likeness> alike;  ///< those where `a` has choices
  /// By structure that can occur, but the whole one: its cases that have choices.
  std::vector<std::vector<std::uint32_t>> ways_on;
};

Cases cases_of(const CandidateOrder& candidate);

/// Cells in which both cases see bricks, different ones: as pairs of bricks.
std::vector<std::pair<std::uint32_t, std::uint32_t>> compared_bricks(const Case& a, const Case& b);

}  // namespace stig
