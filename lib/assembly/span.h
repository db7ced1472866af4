// SPDX-License-Identifier: MIT
// How far a target reaches along an axis.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "assembly/uses.h"
#include "compiler/target_bricks.h"

namespace stig::assembly {

/// The range of one coordinate over all bricks.
struct Span {
  int low = 0, high = 0;
  int width() const { return high - low + 1; }
  /// Twice the distance from the middle.
  int from_middle(int at) const { return std::abs(2 * at - low - high); }
};

/// The target's least and greatest x, y or z. It must have a brick.
Span span_of(const TargetBricks& target, std::int32_t Cell::*coordinate);

}  // namespace stig::assembly
