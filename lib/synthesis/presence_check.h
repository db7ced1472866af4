// SPDX-License-Identifier: MIT
// Rules that ask only that bricks are there, or that a cell does not show some colours, are
// quickly checked, for what they match in a structure they go on matching as it grows.
//
// Let X be the target with its colours. If no rule that matches at a site while all of X is around
// it places anything but X's brick there, and X follows from the start, then every order of
// events ends in X: what is reached lies in X, and as long as a brick is missing, the
// first that is missing of the order in which X follows can be placed. A cell that must not show
// some colour may still be empty: for the first condition it is taken as right, whatever it
// shows; for the second it is right if X shows no such colour there.
#pragma once

#include "synthesis/merge.h"
#include "synthesis/solid_grid.h"
#include "synthesis/uses.h"

namespace stig::synthesis {

/// Colours by place; 0 where the target has no cell.
using PlaceColours = std::vector<Colour>;

/// An order in which the target grows, the start first; nothing unless every order of events
/// ends in the target, or when the allowance is spent. Rules hold as drawn alone.
std::optional<std::vector<std::int32_t>> order_of_growth(const SolidGrid& grid,
                                                         const PlaceColours& colours,
                                                         std::int32_t start,
                                                         const std::vector<MergedRule>& rules,
                                                         const Allowance& allowance);

}  // namespace stig::synthesis
