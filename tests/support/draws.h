// SPDX-License-Identifier: MIT
// What laws draw by lot, inside rc::check.
#pragma once

#include <rapidcheck.h>

#include "base/vec.h"
#include "support/uses.h"

namespace stig {

/// From 0 up to `bound`, which is left out.
inline int below(int bound) { return *rc::gen::inRange(0, bound); }
inline bool chance() { return *rc::gen::arbitrary<bool>(); }

/// From -1 to 1.
inline double unit_value() { return *rc::gen::inRange(-1000, 1001) * 1e-3; }
inline Vec3 some_vector() { return {unit_value(), unit_value(), unit_value()}; }
inline Vec3 some_direction() {
  const Vec3 v = some_vector();
  RC_PRE(squared(v) > 1e-3);
  return normalised(v);
}

}  // namespace stig
