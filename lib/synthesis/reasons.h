// SPDX-License-Identifier: MIT
// Why a target cannot be built, shown.
#pragma once

#include <optional>

#include "synthesis/synthesise.h"

namespace stig {

/// What stands in the way before any order is looked at: the start, a part that is not
/// connected to it, a symmetry that the target lacks.
std::optional<Impossible> find_obstacle(const Target& target, const Placing& placing);

/// Two sites that look alike whatever colours are chosen, side by side.
Impossible describe_look_alikes(const Schedule& schedule, const Clash& clash, const Target& target);

/// More colours are needed than allowed.
Impossible describe_few_colours(int allowed, int needed, std::size_t orders);

}  // namespace stig
