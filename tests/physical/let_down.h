// SPDX-License-Identifier: MIT
// A block let down to one side of its place, as a robot would whose end-effector has no room above
// it: where do magnets and friction leave it?
#pragma once

#include <cstdint>
#include <vector>

#include "physical/trials.h"
#include "support/uses.h"

namespace stig {

/// Where blocks stand about its place, as the robot sees it.
enum class Surroundings : std::uint8_t {
  floor_beside,         ///< on the floor, a column of two to one side, from which it is held away
  floor_beside_behind,  ///< and one behind it
  top_beside_behind,    ///< the same a level higher, on a block
};

/// Of a scene that says nothing about friction, and of the block's file, which the compiler goes
/// by.
inline constexpr SceneFriction kUsualFriction{0.2, 0.4}, kFrictionOfFile{0.5, 0.5};

struct LetDown {
  double way = 0;   ///< m, from the middle of its place in the end
  double turn = 0;  ///< rad
};

/// So many trials, each with other noise: the block is let go `aside` metres from its place, on the
/// side away from the column, and up to 1 mm and 2 degrees off that, 1 to 4 mm above what bears it
/// and 1 to 5 mm before what is behind it. Rising by `way`.
std::vector<LetDown> let_down_aside(const BlockModel& block, Surroundings where, double aside,
                                    const SceneFriction& friction, int trials);

}  // namespace stig
