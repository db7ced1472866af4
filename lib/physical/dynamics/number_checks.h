// SPDX-License-Identifier: MIT
// What numbers of a definition must be; NaN and infinities are none of these.
#pragma once

#include <cmath>

#include "base/vec.h"
#include "physical/dynamics/uses.h"

namespace stig::physics {

inline bool positive(double x) { return std::isfinite(x) && x > 0; }
inline bool not_negative(double x) { return std::isfinite(x) && x >= 0; }
inline bool is_unit(const Vec3& u) { return std::abs(squared(u) - 1) < 1e-6; }
inline bool is_unit(const Quat& q) {
  return std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-6;
}

}  // namespace stig::physics
