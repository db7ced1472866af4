// SPDX-License-Identifier: MIT
// Straight runs of bricks that stand alone, as a proof that so many colours do not do.
//
//     r₀ r₁ r₂ … rₙ _        r₁ … rₙ have no neighbours but each other and r₀; nothing but rₙ is
//                            beside the empty cell behind it
//
// Unless the start is one of r₁ … rₙ, these are placed one after the other, and of all bricks each
// sees the one before it alone. If two of r₀ … rₙ had the same colour, what follows the one would
// follow the other, and so on without an end: a rule would place a brick behind rₙ. So n is less
// than the number k of colours. When the start is rⱼ, the same holds of rⱼ … rₙ and, for building
// from rⱼ meets nothing else before it leaves this line, of rⱼ … r₀: n - j and j are less than k.
// That is so for every rule set that is proved to build the target and nothing else, in whatever
// order.
#pragma once

#include <optional>
#include <vector>

#include "assembly/uses.h"
#include "compiler/target_bricks.h"

namespace stig::assembly {

/// r₀ … rₙ, the free end last.
using FreeRun = std::vector<Cell>;

/// Runs, all on one level, that leave no cell for the start with so many colours: one, two or more.
/// Empty where some cell is left, or `start`, where one is given.
std::vector<FreeRun> runs_too_long(const TargetBricks& target, std::optional<std::uint32_t> start,
                                   int colours);

}  // namespace stig::assembly
