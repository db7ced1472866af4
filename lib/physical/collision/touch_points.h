// SPDX-License-Identifier: MIT
// From the points of a clipped face to the four that a Touch keeps, and the kinds of pairs that
// contact.cpp tells apart: box_touch.cpp, convex_touch.cpp, round_touch.cpp.
#pragma once

#include "physical/collision/contact.h"

namespace stig::physics {

/// Two convex quadrilaterals meet in at most eight corners.
struct PointList {
  std::array<TouchPoint, 16> points;
  int count = 0;

  void add(const Vec3& p, double gap) { points[static_cast<std::size_t>(count++)] = {p, gap}; }
};

/// All when there are four or fewer; otherwise the deepest and those that span most.
Touch reduced(const Vec3& normal, const TouchPoint* points, int count);
/// The point, when it is nearer than the margin.
Touch single_touch(const Vec3& normal, const Vec3& p, double gap, double margin);
/// Midway between two lines, where they are nearest; the directions are unit and not parallel.
Vec3 lines_meet(const Vec3& pa, const Vec3& ua, const Vec3& pb, const Vec3& ub);

Touch touch_boxes(const Placed& a, const Placed& b, double margin);

/// Where two boxes are farthest apart, or overlap least.
struct BoxAxis {
  Vec3 n;  ///< unit, from b to a
  double gap = -1e30;
  int kind = 0;  ///< 0…2: face of a, 3…5: face of b, 6…14: edges
};
/// Boxes that overlap by no more than this along some axis slide past each other, and edges that
/// do so along two axes do not touch: a block that is pushed over a seam must not take the
/// next block's side for a wall.
inline constexpr double kGraze = 0.2e-3;
/// An edge's axis wins over the faces' best only by more than this, m; so does a later face.
inline constexpr double kFacePreference = 1e-4;
/// Half the box's extent along a unit vector.
double extent(const Placed& box, const Vec3& n);
/// The points of contact with that axis as the normal.
Touch touch_boxes_along(const Placed& a, const Placed& b, const BoxAxis& axis, double margin);
/// The touch of boxes, hulls and cylinders, the latter as prisms.
Touch touch_hulls(const Placed& a, const Placed& b, double margin);
// The sphere is a.
Touch touch_sphere_hull(const Placed& ball, const Placed& hull, double margin);
Touch touch_sphere_cylinder(const Placed& ball, const Placed& cylinder, double margin);
Touch touch_floor_cylinder(const Placed& a, double margin);

}  // namespace stig::physics
