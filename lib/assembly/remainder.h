// SPDX-License-Identifier: MIT
// What is left of a structure when it is taken apart, as the proof that no order builds it.
//
// With fewer bricks about a site there is never less room: lanes, slots, covers and the
// end-effector's place only get free. What can get lost is a hold, or a column to put a brick next
// to, and that a column behind the site stops the end-effector before others. With all of that
// granted for nothing, a brick that can be put last among some bricks can be put last among fewer
// of them. So taking away whatever can be taken away, in any order, leaves the same remainder.
//
//     If two bricks or more remain, no order of work builds the structure.
//
// For in every order one of them comes last, and is no start then; the others stand, and bar it
// from every side. The remainder says nothing of what bears a brick: where none is left, there may
// still be no order.
//
// One thing more can be asked. Bricks are put next to others, so that what stands hangs together,
// face to face. A brick without which two others would not, even in the whole structure, has to be
// there before one of them, so it cannot be put last while both stand; with fewer bricks there are
// no more ways from the one to the other.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "assembly/sequence.h"
#include "assembly/uses.h"

namespace stig::assembly {

/// Why a brick cannot be put last, from one side.
struct Bar {
  ApproachSide side{};
  ReachResult why;
};
struct BarredBrick {
  std::uint32_t brick = 0;
  std::vector<Bar> bars;  ///< from each side; empty where it joins others
  /// Two that hang together through it alone.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> joins;
};

struct Remainder {
  BrickSet bricks{0};               ///< empty: the proof does not go through
  std::vector<BarredBrick> barred;  ///< each of them but a given start
};

/// `start`: a brick that is there from the beginning; none: any may be.
Remainder find_remainder(const TargetBricks& target, const Builders& builders,
                         std::optional<std::uint32_t> start);

}  // namespace stig::assembly
