// SPDX-License-Identifier: MIT
// A policy proved column by column (local_situations.h), without a list of structures.
//
// A placement is allowed where, in every structure that shows the same, it is right and within
// reach, and all that comes before it stands. Then whatever is done leaves a closed structure, and
// of those none is a dead end, if
//
//     way on  in some order of the bricks, for each brick q there is a column next to it such that,
//             in each closed structure that has all bricks before q in that order and lacks q,
//             robots come to that column and something is to be done there.
//
// For of a structure that is not whole take the first missing brick as q. So every maximal order of
// allowed placements ends in the whole structure.
//
// The condition is stricter than a walk over all structures: one of a dead end is never given up
// for another, since there is to be none. Where it fails, nothing is known.
#pragma once

#include "compiler/compile.h"
#include "compiler/precedence.h"
#include "compiler/uses.h"

namespace stig::compiler {

/// Situations before one column, and all in all, at most.
inline constexpr std::size_t kMostAtColumn = 20'000, kMostLocalSituations = 4'000'000;

/// Fills in policy, decision, concurrency and local_situations; false, and no decision, when this
/// proves nothing.
bool settle_locally(const Abilities& robot, const PolicyLimits& limits, CompiledRules& compiled);

}  // namespace stig::compiler
