// SPDX-License-Identifier: MIT
#include "assembly/span.h"

#include <algorithm>
#include <cassert>

namespace stig::assembly {

Span span_of(const TargetBricks& target, std::int32_t Cell::*coordinate) {
  assert(target.bricks() > 0);
  Span out{target.cell(0).*coordinate, target.cell(0).*coordinate};
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    out.low = std::min(out.low, target.cell(i).*coordinate);
    out.high = std::max(out.high, target.cell(i).*coordinate);
  }
  return out;
}

}  // namespace stig::assembly
