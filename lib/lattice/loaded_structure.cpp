// SPDX-License-Identifier: MIT
// The limits that all readers of structures share. A brick of a file takes a few bytes and
// may touch a chunk of 512 cells of its own, so the number of chunks is what memory depends
// on, and it is counted before anything is built.
#include "lattice/loaded_structure.h"

#include <fmt/format.h>

#include <algorithm>

#include "rules/cell_text.h"

namespace stig::lattice {

namespace {

bool in_range(std::int32_t value) { return value >= -kMaxCoordinate && value <= kMaxCoordinate; }

/// The shift is arithmetic and rounds down for negative coordinates too, as Structure does.
Cell chunk_of(Cell cell) {
  static_assert(Structure::kChunkSide == 8);
  return {cell.x >> 3, cell.y >> 3, cell.z >> 3};
}

std::size_t count_chunks(const std::vector<PlacedBrick>& bricks) {
  std::vector<Cell> chunks;
  chunks.reserve(bricks.size());
  // Neighbours in the list mostly share a chunk, so the list stays short before it is
  // sorted.
  for (const PlacedBrick& brick : bricks) {
    const Cell chunk = chunk_of(brick.at);
    if (chunks.empty() || chunks.back() != chunk) chunks.push_back(chunk);
  }
  std::sort(chunks.begin(), chunks.end());
  return static_cast<std::size_t>(std::unique(chunks.begin(), chunks.end()) - chunks.begin());
}

}  // namespace

std::optional<BrickListProblem> find_problem(std::vector<PlacedBrick>& bricks) {
  using Kind = BrickListProblem::Kind;
  if (bricks.size() > kMostFileBricks) return BrickListProblem{Kind::too_many, {}};
  for (const PlacedBrick& brick : bricks) {
    if (!in_range(brick.at.x) || !in_range(brick.at.y) || !in_range(brick.at.z)) {
      return BrickListProblem{Kind::coordinate, brick.at};
    }
  }
  // Sorting serves three ends: finding repeated cells, counting chunks, and a fixed order
  // of insertion.
  std::sort(bricks.begin(), bricks.end());
  const auto same_cell = [](const PlacedBrick& a, const PlacedBrick& b) { return a.at == b.at; };
  const auto twice = std::adjacent_find(bricks.begin(), bricks.end(), same_cell);
  if (twice != bricks.end()) return BrickListProblem{Kind::cell_twice, twice->at};
  if (count_chunks(bricks) > kMostFileChunks) return BrickListProblem{Kind::too_scattered, {}};
  return std::nullopt;
}

std::string to_string(const BrickListProblem& problem) {
  switch (problem.kind) {
    case BrickListProblem::Kind::cell_twice:
      return fmt::format("cell {} is given twice", cell_text(problem.at));
    case BrickListProblem::Kind::coordinate:
      return fmt::format("cell {} lies outside ±{}", cell_text(problem.at), kMaxCoordinate);
    case BrickListProblem::Kind::too_many:
      return fmt::format("more than {} bricks", kMostFileBricks);
    case BrickListProblem::Kind::too_scattered:
      return fmt::format("the bricks are scattered over more than {} blocks of {}³ cells",
                         kMostFileChunks, Structure::kChunkSide);
  }
  return {};
}

}  // namespace stig::lattice
