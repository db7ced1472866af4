// SPDX-License-Identifier: MIT
// Columns before which a robot stands, and places next to them.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/approach.h"
#include "compiler/sight.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// Columns from which a robot may put a brick, as (u, v) from the brick's own: that one, the one
/// behind it, and those beside it.
inline constexpr std::array<std::pair<int, int>, 4> kColumnsAbout = {
    {{0, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Foremost columns of a structure's rows as (v, u), by row: those that a robot can drive up to
/// from this side, as far as to put a block before them.
std::vector<std::pair<int, int>> columns_before(const TargetBricks& target, const BrickSet& state,
                                                ApproachSide side);

/// Is it one of them?
bool comes_to_column(const TargetBricks& target, const BrickSet& state, ApproachSide side, int u,
                     int v);

/// Where a missing brick is from the column (u, v), when it is next to it: on top, in front of a
/// brick or beside one.
std::optional<WindowCell> next_to_column(const TargetBricks& target, const BrickSet& state,
                                         ApproachSide side, int u, int v, std::uint32_t brick);

/// The whole structure's bricks on, before and beside a column, whatever stands.
std::vector<std::uint32_t> bricks_about(const TargetBricks& target, ApproachSide side, int u,
                                        int v);

}  // namespace stig::compiler
