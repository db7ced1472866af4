// SPDX-License-Identifier: MIT
// Which bricks are enumerated together: groups of windows, and how they grow.
#pragma once

#include <optional>
#include <vector>

#include "verify/local_proof.h"
#include "verify/uses.h"
#include "verify/window.h"

namespace stig::verify {

/// Bricks of each group by rising number; no two groups have bricks beside each other.
using Groups = std::vector<std::vector<std::uint32_t>>;

/// Groups of more bricks than this are not enumerated.
inline constexpr std::size_t kMostGroup = 4096;

/// Takes in what failures of local states are about, at first little, in the end all bricks;
/// `round` counts from 0. None: that would be more than kMostGroup.
std::optional<Groups> grown(const StageModel& model, const Groups& groups,
                            const std::vector<LocalFailure>& failures, int round);

/// Moves a brick from the context of a window into its group.
void take_into_group(Invariant& invariant, std::uint32_t brick, std::uint32_t window);

/// The brick of a window's context with which in its group the search gets farthest, of those
/// that do not touch another group; StageModel::kNone: there is none.
std::uint32_t most_helpful(const StageModel& model, const Invariant& invariant,
                           std::uint32_t window, const Budget& budget);

}  // namespace stig::verify
