// SPDX-License-Identifier: MIT
// Can somebody who knows everything have the bricks put in some order? Every set of bricks that
// placements lead to from a start is walked, each placement held to the robot's reach.
#pragma once

#include <optional>

#include "assembly/sequence.h"
#include "support/uses.h"

namespace stig {

/// Nothing when more than `most` sets would have to be looked at.
std::optional<bool> can_be_built(const TargetBricks& target, const Builders& builders,
                                 std::size_t most);

}  // namespace stig
