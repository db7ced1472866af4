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

/// Colours in place of a file's own, told apart with any kind of colour vision: those of Okabe and
/// Ito (2008), "Color universal design", and Tol's bright scheme (SRON/EPS/TN/09-002). Those of
/// tools/viewer/src/colours.ts, in the same order.
enum class Palette : std::uint8_t { file, okabe_ito, tol_bright };
/// Colour k of the palette, from 1; after the last comes the first again. Not of Palette::file.
Rgb rgb_in(Palette palette, Colour colour);
/// The bricks with the palette's colours, and as many more as there are colours up to `most`.
std::vector<Brick> recoloured(std::vector<Brick> bricks, Palette palette, Colour most);

/// The symbol of a colour; its number when `bricks` has no such brick.
std::string symbol_of(const std::vector<Brick>& bricks, Colour colour);

}  // namespace stig::lattice
