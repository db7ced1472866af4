// SPDX-License-Identifier: MIT
// Cylinders against the floor and against balls, exactly; against the rest they are prisms.
//
// A prism on the floor would roll in 20 jolts a turn; wheels have to roll smoothly. So the lowest
// line or rim is found exactly. A ball against a cylinder is a point against a solid of revolution:
// a problem in the half plane through the axis.
#include <algorithm>
#include <cassert>

#include "physical/collision/touch_points.h"

namespace stig::physics {

namespace {

constexpr double kStraight = 1e-6;  ///< sine of a tilt below which a cap is level

/// The cap's rim: its lowest point, and three more at right angles from it, which matter when
/// it stands.
void add_rim(const Placed& a, const Vec3& centre, double margin, PointList& out) {
  const Vec3 axis = a.r.z;
  // The steepest way down within the cap: the projection of "down" onto it.
  const Vec3 down = Vec3{0, 0, -1} + axis * axis.z;
  const double tilt = length(down);
  const Vec3 u = tilt > kStraight ? down * (1 / tilt) : a.r.x;
  const Vec3 v = cross(axis, u);
  const double r = a.shape.half.x;
  for (const Vec3& at : {u, v, -u, -v}) {
    const Vec3 p = centre + at * r;
    if (p.z < margin) out.add({p.x, p.y, p.z / 2}, p.z);
  }
}

}  // namespace

Touch touch_floor_cylinder(const Placed& a, double margin) {
  assert(a.shape.kind == ShapeKind::cylinder);
  PointList points;
  const Vec3 half = a.r.z * a.shape.half.z;
  // Lying: the two ends of its lowest line. Standing: the rim of one cap. With its axis more than
  // about 45° away from upright it counts as lying.
  const double level = std::abs(a.r.z.z);
  if (level < 0.7) {
    const Vec3 down = normalised(Vec3{0, 0, -1} + a.r.z * a.r.z.z) * a.shape.half.x;
    for (const Vec3& p : {a.p + half + down, a.p - half + down}) {
      if (p.z < margin) points.add({p.x, p.y, p.z / 2}, p.z);
    }
  } else {
    add_rim(a, a.r.z.z > 0 ? a.p - half : a.p + half, margin, points);
  }
  return reduced({0, 0, 1}, points.points.data(), points.count);
}

Touch touch_sphere_cylinder(const Placed& ball, const Placed& cylinder, double margin) {
  const Vec3 h = cylinder.shape.half;
  const Vec3 c = cylinder.r.transposed(ball.p - cylinder.p);
  const double across = std::hypot(c.x, c.y), r = ball.shape.half.x;
  // A ball on the axis has no radial direction; any will do.
  const Vec3 out = across > 0 ? Vec3{c.x / across, c.y / across, 0} : Vec3{1, 0, 0};
  const Vec3 nearest = out * std::min(across, h.x) + Vec3{0, 0, std::clamp(c.z, -h.z, h.z)};
  // Outside by the side, a cap or the rim: the nearest point says which.
  if (across > h.x || std::abs(c.z) > h.z) {
    const double outside = length(c - nearest);
    const Vec3 n = cylinder.r * ((c - nearest) * (1 / outside));
    const double gap = outside - r;
    return single_touch(n, cylinder.p + cylinder.r * nearest + n * (gap / 2), gap, margin);
  }
  // The centre is inside: out through the cap or the side, whichever is nearer.
  const double to_side = h.x - across, to_cap = h.z - std::abs(c.z);
  const Vec3 n = to_side < to_cap ? out : Vec3{0, 0, c.z < 0 ? -1.0 : 1.0};
  return single_touch(cylinder.r * n, ball.p, -std::min(to_side, to_cap) - r, margin);
}

}  // namespace stig::physics
