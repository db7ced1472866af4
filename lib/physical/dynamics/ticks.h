// SPDX-License-Identifier: MIT
// Periods in seconds as numbers of a world's steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "physical/dynamics/uses.h"

namespace stig::physics {

/// The nearest number of steps of `step` s, and never none.
inline std::uint64_t ticks_in(double seconds, double step) {
  return static_cast<std::uint64_t>(std::max<long long>(1, std::llround(seconds / step)));
}

}  // namespace stig::physics
