// SPDX-License-Identifier: MIT
// Paths over the columns of a target, from one to those beside it.
#pragma once

#include <vector>

#include "assembly/uses.h"
#include "compiler/target_bricks.h"

namespace stig::assembly {

/// By brick, how many steps its column is from that of `first` on a path that does not go through
/// the column of `last`. What no path leads to counts as one step farther than all else, and so
/// does the column of `last`, and what lies on `first`: there it would be in the way of what is put
/// beside at the end.
std::vector<int> steps_from(const TargetBricks& target, Cell first, Cell last);

}  // namespace stig::assembly
