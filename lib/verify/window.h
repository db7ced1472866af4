// SPDX-License-Identifier: MIT
// Every filling of a group of bricks, found by exhaustion.
//
// The group's own bricks follow the rules exactly. The bricks around them (the context)
// are granted more than they can do: one may come as soon as what is known to be before
// it is there. So every filling that can occur is found, and perhaps some that cannot. A
// window without context is exact: each of its fillings can be reached.
#pragma once

#include <optional>
#include <vector>

#include "verify/budget.h"
#include "verify/invariant.h"
#include "verify/uses.h"

namespace stig::verify {

struct WindowFailure {
  enum class Kind : std::uint8_t {
    wrong,     ///< in a filling, a group brick's site takes another colour
    stuck,     ///< in a filling that lacks group bricks, no rule goes on
    too_many,  ///< more fillings than the budget has
  };
  Kind kind = Kind::too_many;
  std::size_t filling = 0;
  std::uint32_t site = 0;  ///< wrong: where
};

/// Fills in context (all bricks beside the group that are not in it) and fillings.
std::optional<WindowFailure> explore_window(const StageModel& model, const Invariant& invariant,
                                            const Budget& budget, Window& window);

/// The bricks of a filling, in an order in which the search added them.
std::vector<std::uint32_t> path_to(const Window& window, std::size_t filling);

}  // namespace stig::verify
