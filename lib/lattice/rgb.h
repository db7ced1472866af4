// SPDX-License-Identifier: MIT
// Brick colours as numbers, for files and pictures.
#pragma once

#include <string>
#include <vector>

#include "base/rgb.h"
#include "lattice/uses.h"
#include "rules/rule_set.h"

namespace stig::lattice {

/// The colour of brick `colour`; one of a built-in palette, distinct for small
/// numbers, when `bricks` has no such brick or its colour is not "#rrggbb".
Rgb rgb_of(const std::vector<Brick>& bricks, Colour colour);

/// Bricks 1..count of the built-in palette, with symbols and names "1", "2", ….
std::vector<Brick> numbered_bricks(int count);

/// The symbol of a colour; its number when `bricks` has no such brick.
std::string symbol_of(const std::vector<Brick>& bricks, Colour colour);

}  // namespace stig::lattice
