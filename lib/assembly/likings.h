// SPDX-License-Identifier: MIT
// Likings that candidates are made by, one after the other.
#pragma once

#include <array>

#include <vector>

#include "assembly/sequence.h"
#include "assembly/uses.h"

namespace stig::assembly {

/// Some that begin with a spine and sweep the rows beside it (texture.h), for large structures:
/// those first that leave the colours least to count.
std::vector<Liking> swept_likings(const TargetBricks& target, int colours);
/// These, and among them one for plates that counts in digits (counted.h), where they can be:
/// before spines that would have to count farther than is found soon.
std::vector<Liking> large_likings(const TargetBricks& target, int colours);
/// The sides from which a counted plate is built.
inline constexpr std::array kCountedSides = {ApproachSide::plus_x, ApproachSide::plus_y};
/// Some that go once round a closed chain of columns, for targets that have one: from a column
/// next to a bend, with the bend as the last.
std::vector<Liking> round_likings(const TargetBricks& target);
/// Others that go row by row: robots tell sites apart by little there.
std::vector<Liking> regular_likings();
/// One by chance.
Liking liking_of(std::uint64_t seed);

/// May robots at these sides build so? A spine grows from its two sides or from its two ends, and
/// rows beside it from its sides. What goes round grows towards each side in turn.
bool suits(const TargetBricks& target, const Liking& liking,
           const std::vector<ApproachSide>& sides);

}  // namespace stig::assembly
