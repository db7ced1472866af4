// SPDX-License-Identifier: MIT
// Files and people have degrees, the code radians.
#pragma once

#include <numbers>

namespace stig {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< rad

}  // namespace stig
