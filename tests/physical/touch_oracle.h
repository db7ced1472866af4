// SPDX-License-Identifier: MIT
// How far apart convex bodies are, slow and obvious.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physical/collision/contact.h"
#include "support/uses.h"

namespace stig {

/// The smallest gap of a touch, 1e9 of none.
inline double deepest(const Touch& touch) {
  double least = 1e9;
  for (int i = 0; i < touch.count; ++i) {
    least = std::min(least, touch.points[static_cast<std::size_t>(i)].gap);
  }
  return least;
}

/// How far a shape reaches along a direction.
inline double reach(const Placed& a, const Vec3& n) {
  const Vec3 d = a.r.transposed(n), h = a.shape.half;
  if (a.shape.kind == ShapeKind::box) {
    return dot(n, a.p) + std::abs(d.x) * h.x + std::abs(d.y) * h.y + std::abs(d.z) * h.z;
  }
  if (a.shape.kind == ShapeKind::sphere) return dot(n, a.p) + h.x;
  double most = -1e9;
  for (const Vec3& p : a.shape.convex->points) most = std::max(most, dot(d, p));
  return dot(n, a.p) + most;
}

/// The most by which one of many directions parts two convex bodies.
inline double sampled_separation(const Placed& a, const Placed& b) {
  double best = -1e9;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 120; ++k) {
      const double z = (i + 0.5) / 30 - 1, s = std::sqrt(1 - z * z);
      const double t = k * std::numbers::pi / 60;
      const Vec3 n{s * std::cos(t), s * std::sin(t), z};
      best = std::max(best, -reach(a, -n) - reach(b, n));
    }
  }
  return best;
}

}  // namespace stig
