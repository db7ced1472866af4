// SPDX-License-Identifier: MIT
// Placements held to the rules, one after the other.
#pragma once

#include "validate/judge.h"
#include "validate/uses.h"

namespace stig::validate {

struct Replayed {
  std::size_t placements = 0;  ///< all of them
  std::size_t allowed = 0;     ///< in a row from the first
  std::optional<AgainstRules> against;
};

/// In the structure as it stood at each time, bricks that had left taken away again.
Replayed replay_events(const BuildTarget& target, const std::vector<BrickEvent>& events);

}  // namespace stig::validate
