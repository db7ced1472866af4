// SPDX-License-Identifier: MIT
// Why a target cannot be built, shown.
#pragma once

#include <optional>

#include "synthesis/synthesise.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// What stands in the way before any order is looked at: the start, a part that is not
/// connected to it, a symmetry that the target lacks.
std::optional<Obstacle> find_obstacle(const Target& target, const Placing& placing);

/// The given start and one cell of every part of the target that is not connected to it.
std::vector<Cell> one_of_each_part(const Target& target, const std::vector<Cell>& start);

/// Two sites that look alike whatever colours are chosen, side by side.
Obstacle describe_look_alikes(const Schedule& schedule, const Clash& clash, const Target& target);

/// More colours are needed than allowed: the cells that must all differ, or the sites
/// that the solver's refutation rests on, for the order that needs the fewest.
Obstacle describe_few_colours(const Schedule& schedule, int named, int allowed, int needed,
                              const Allowance& allowance);

}  // namespace stig::synthesis
