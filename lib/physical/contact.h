// SPDX-License-Identifier: MIT
// Where two shapes touch, or are about to: boxes, spheres and the floor z = 0.
//
// Boxes are told apart by the separating-axis test (Gottschalk, Lin and Manocha 1996); the
// axis of least overlap becomes the normal, and the face that lies most against it is
// clipped against the other's. Faces are preferred to edges by a hair, so that resting
// boxes keep the same points from step to step.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec.h"

namespace stig {

enum class ShapeKind : std::uint8_t { box, sphere };

struct Shape {
  ShapeKind kind = ShapeKind::box;
  Vec3 half;  ///< half the edges of a box; of a sphere: its radius in x

  static Shape box(const Vec3& edges) { return {ShapeKind::box, edges * 0.5}; }
  static Shape sphere(double radius) { return {ShapeKind::sphere, {radius, radius, radius}}; }
  /// Of the ball around its centre that holds it.
  double radius() const { return kind == ShapeKind::box ? length(half) : half.x; }
};

/// A shape where it is.
struct Placed {
  Shape shape;
  Vec3 p;  ///< its centre
  Mat3 r;  ///< its axes
};

struct TouchPoint {
  Vec3 p;          ///< midway between the surfaces, world frame
  double gap = 0;  ///< m; negative: overlap
};

/// At most four points, enough for two flat faces.
struct Touch {
  Vec3 normal;  ///< unit, from b to a
  std::array<TouchPoint, 4> points;
  int count = 0;
};

/// Points nearer than `margin`.
Touch touch(const Placed& a, const Placed& b, double margin);
Touch touch_floor(const Placed& a, double margin);

}  // namespace stig
