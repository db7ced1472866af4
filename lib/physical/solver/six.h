// SPDX-License-Identifier: MIT
// Twists and wrenches as six numbers, for sums over rows and columns of matrices.
#pragma once

#include <array>

#include "physical/solver/solver.h"

namespace stig::physics {

/// Force and torque, or velocity and spin, of which the first three go first.
using Six = std::array<double, 6>;

inline Six six_of(const Twist& twist) {
  return {twist.v.x, twist.v.y, twist.v.z, twist.w.x, twist.w.y, twist.w.z};
}
inline Twist twist_of(const Six& six) {
  return {{six[0], six[1], six[2]}, {six[3], six[4], six[5]}};
}

}  // namespace stig::physics
