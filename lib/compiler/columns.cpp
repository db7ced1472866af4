// SPDX-License-Identifier: MIT
#include "compiler/columns.h"

#include <cmath>
#include <map>

namespace stig::compiler {

namespace {

/// Where the bricks of a row that stand end towards the robot; nothing where none stands.
std::optional<int> end_of_row(const TargetBricks& target, const BrickSet& state, ApproachSide side,
                              int v) {
  std::optional<int> out;
  for (const std::uint32_t i : row_from(target, side, v)) {
    if (!state.has(i)) continue;
    const int u = seen_from(side, target.cell(i)).u;
    out = std::max(out.value_or(u), u);
  }
  return out;
}

/// By row: the foremost column. Only the foremost brick of a row can be driven up to; those
/// behind it are out of sight and reach.
std::map<int, int> foremost(const TargetBricks& target, const BrickSet& state, ApproachSide side) {
  std::map<int, int> out;
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    if (!state.has(i)) continue;
    const SideCell at = seen_from(side, target.cell(i));
    const auto [row, added] = out.emplace(at.v, at.u);
    if (!added) row->second = std::max(row->second, at.u);
  }
  return out;
}

}  // namespace

/// A robot is wider than a block, so rows on both sides must leave its body room: no column
/// there may stand further out than one cell before this one.
std::vector<std::pair<int, int>> columns_before(const TargetBricks& target, const BrickSet& state,
                                                ApproachSide side) {
  const std::map<int, int> rows = foremost(target, state, side);
  std::vector<std::pair<int, int>> out;
  for (const auto& [v, u] : rows) {
    bool free = true;
    for (const int beside : {v - 1, v, v + 1}) {
      const auto row = rows.find(beside);
      free = free && (row == rows.end() || row->second < u + 2);
    }
    if (free) out.emplace_back(v, u);
  }
  return out;
}

bool comes_to_column(const TargetBricks& target, const BrickSet& state, ApproachSide side, int u,
                     int v) {
  if (end_of_row(target, state, side, v) != u) return false;
  for (const int beside : {v - 1, v + 1}) {
    const std::optional<int> end = end_of_row(target, state, side, beside);
    if (end && *end >= u + 2) return false;
  }
  return true;
}

/// A robot before a column can serve the column itself, the cell before it, and the two
/// beside it.
std::vector<std::uint32_t> bricks_about(const TargetBricks& target, ApproachSide side, int u,
                                        int v) {
  std::vector<std::uint32_t> out;
  for (const auto& [du, dv] : {std::pair(0, 0), {1, 0}, {0, 1}, {0, -1}}) {
    for (int z = 0; z < target.levels(); ++z) {
      const std::uint32_t brick =
          target.brick_at(cell_from(side, {u + du, v + dv, z + target.floor_level()}));
      if (brick != TargetBricks::kNone) out.push_back(brick);
    }
  }
  return out;
}

/// A place is next to the column if there is a brick to put the block against or on.
std::optional<WindowCell> next_to_column(const TargetBricks& target, const BrickSet& state,
                                         ApproachSide side, int u, int v, std::uint32_t brick) {
  const SideCell site = seen_from(side, target.cell(brick));
  const WindowCell cell{site.u - u, site.v - v, site.z - target.floor_level()};
  const auto filled = [&](int z) { return target.filled(state, cell_from(side, {u, v, z})); };
  const bool beside_it = std::abs(cell.du) + std::abs(cell.dv) == 1 && cell.du >= 0;
  const bool next = beside_it ? filled(site.z) : cell.du == 0 && cell.dv == 0 && filled(site.z - 1);
  return next ? std::optional(cell) : std::nullopt;
}

}  // namespace stig::compiler
