// SPDX-License-Identifier: MIT
// What the readers of structure files hand back, and the limits they share.
//
// A file may be hostile: a few bytes can name a cell anywhere, and a chunk of a
// Structure holds 512 cells, so scattered cells cost far more memory than file.
// Readers therefore collect bricks first and build the Structure here.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lattice/structure.h"
#include "lattice/uses.h"

namespace stig::lattice {

struct LoadedStructure {
  Structure structure;
  std::vector<Brick> bricks;  ///< colour k is bricks[k - 1], as in a rule set
  /// Does the file say where the structure stands? If not, its lowest corner is (0, 0, 0).
  bool placed = true;
};

inline constexpr std::size_t kMostFileBytes = std::size_t{1} << 28;   ///< of one structure file
inline constexpr std::size_t kMostFileBricks = std::size_t{1} << 25;  ///< bricks in one file
inline constexpr std::size_t kMostFileChunks = std::size_t{1} << 20;  ///< about 540 MB

/// What is wrong with a list of bricks; nothing when it can be built.
struct BrickListProblem {
  enum class Kind { cell_twice, coordinate, too_many, too_scattered };
  Kind kind;
  Cell at;  ///< cell_twice and coordinate: where
};

/// Checks coordinates (within ±kMaxCoordinate) and limits, then that no cell comes
/// twice. Sorts the list by cell.
std::optional<BrickListProblem> find_problem(std::vector<PlacedBrick>& bricks);

/// The problem in words, for a diagnostic.
std::string to_string(const BrickListProblem& problem);

}  // namespace stig::lattice
