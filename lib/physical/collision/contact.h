// SPDX-License-Identifier: MIT
// Where two shapes touch, or are about to: boxes, spheres, cylinders, convex hulls and the
// floor z = 0.
//
// Boxes are told apart by the separating-axis test (Gottschalk, Lin and Manocha 1996); the
// axis of least overlap becomes the normal, and the face that lies most against it is
// clipped against the other's. Faces are preferred to edges by a hair, so that resting
// boxes keep the same points from step to step. Hulls do the same. A cylinder is exact against the
// floor and spheres, so that it rolls smoothly; against the rest it is a prism of 20 sides,
// whose corners are on it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "base/vec.h"
#include "physical/collision/convex.h"

namespace stig::physics {

enum class ShapeKind : std::uint8_t { box, sphere, cylinder, hull };

struct Shape {
  ShapeKind kind = ShapeKind::box;
  /// Half the edges of a box, also of the one about a cylinder (along z) or a hull; of a
  /// sphere: its radius, thrice.
  Vec3 half;
  std::shared_ptr<const Convex> convex = {};  ///< of a cylinder: its prism; of a hull: itself

  static Shape box(const Vec3& edges) { return {ShapeKind::box, edges * 0.5, {}}; }
  static Shape sphere(double radius) { return {ShapeKind::sphere, {radius, radius, radius}, {}}; }
  /// Along z.
  static Shape cylinder(double radius, double height);
  /// The hull of 4 to 64 points about the body's origin, its centre of mass. Points that enclose
  /// nothing give a shape without extent, which no world takes.
  static Shape hull(const std::vector<Vec3>& points);
  /// The radius of the smallest ball around its centre that contains it.
  double radius() const;
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

/// How two shapes move against each other in a step.
struct Passing {
  Vec3 way;            ///< m, of a against b
  double turning = 0;  ///< m, that their surfaces may come nearer by turning
  double margin = 0;   ///< m: that much apart all the way, they are no contact
  double most = 0;     ///< m: points nearer than this count
  double share = 0.5;  ///< of the way, that a moves
};
/// Boxes where they will meet on their way, with the axis as the normal along which they meet
/// last, and gaps as they are now; a box that passes beside another does not touch it. They pass
/// when they overlap by at most 0.2 mm, so that nothing snags on seams.
Touch touch_moving_boxes(const Placed& a, const Placed& b, const Passing& motion);

/// Points nearer than `margin`.
Touch touch(const Placed& a, const Placed& b, double margin);
Touch touch_floor(const Placed& a, double margin);

}  // namespace stig::physics
