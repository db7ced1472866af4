// SPDX-License-Identifier: MIT
// The dispatch over pairs of shapes, and the cases with a sphere or the floor, which have closed
// forms. Normals point from b to a, gaps are negative when shapes overlap, and points lie midway
// between the two surfaces.
#include "physical/collision/contact.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "physical/collision/touch_points.h"

namespace stig::physics {

namespace {

constexpr int kSides = 20;  ///< of the prism that stands for a cylinder

/// Index of the point for which `score` is largest; of equal ones the first.
template <class Score>
int best(const TouchPoint* points, int count, Score score) {
  int at = 0;
  double most = score(points[0]);
  for (int i = 1; i < count; ++i) {
    const double value = score(points[i]);
    if (value > most) std::tie(most, at) = std::pair(value, i);
  }
  return at;
}

Touch touch_spheres(const Placed& a, const Placed& b, double margin) {
  const Vec3 d = a.p - b.p;
  const double distance = length(d);
  // Two centres in one place have no direction: up, as good as any.
  const Vec3 n = distance > 0 ? d * (1 / distance) : Vec3{0, 0, 1};
  const double gap = distance - a.shape.half.x - b.shape.half.x;
  return single_touch(n, b.p + n * (b.shape.half.x + gap / 2), gap, margin);
}

/// The sphere is a.
Touch touch_sphere_box(const Placed& a, const Placed& b, double margin) {
  // In the box's frame, where the nearest point of a solid box is a clamp.
  const Vec3 h = b.shape.half;
  const Vec3 c = b.r.transposed(a.p - b.p);
  const Vec3 nearest{std::clamp(c.x, -h.x, h.x), std::clamp(c.y, -h.y, h.y),
                     std::clamp(c.z, -h.z, h.z)};
  const double outside = length(c - nearest);
  if (outside > 0) {
    const Vec3 n = b.r * ((c - nearest) * (1 / outside));
    const double gap = outside - a.shape.half.x;
    return single_touch(n, b.p + b.r * nearest + n * (gap / 2), gap, margin);
  }
  // The centre is inside: out through the nearest face.
  const std::array<double, 3> depth{h.x - std::abs(c.x), h.y - std::abs(c.y), h.z - std::abs(c.z)};
  const auto axis = static_cast<int>(std::min_element(depth.begin(), depth.end()) - depth.begin());
  const double side = axis == 0 ? c.x : axis == 1 ? c.y : c.z;
  const Vec3 n = b.r.column(axis) * (side < 0 ? -1.0 : 1.0);
  return single_touch(n, a.p, -depth[static_cast<std::size_t>(axis)] - a.shape.half.x, margin);
}

/// In a cylinder of radius 1 and height 2.
std::shared_ptr<const Convex> unit_prism() {
  // The corners lie on the circle: a prism is as wide as its cylinder, and never wider.
  std::vector<Vec3> corners;
  for (int i = 0; i < kSides; ++i) {
    const double a = 2 * std::numbers::pi * i / kSides;
    const Vec3 rim{std::cos(a), std::sin(a), 1};
    corners.push_back(rim);
    corners.push_back({rim.x, rim.y, -1});
  }
  return convex_of(corners);
}

}  // namespace

Shape Shape::cylinder(double radius, double height) {
  // A hull takes a millisecond to find, and a crowd of robots has hundreds of cylinders.
  static const std::shared_ptr<const Convex> kPrism = unit_prism();
  const Vec3 half{radius, radius, height / 2};
  return {ShapeKind::cylinder, half, stretched(*kPrism, half)};
}

Shape Shape::hull(const std::vector<Vec3>& points) {
  Shape out{ShapeKind::hull, {}, convex_of(points)};
  if (out.convex) out.half = out.convex->half;
  return out;
}

double Shape::radius() const {
  if (kind == ShapeKind::sphere) return half.x;
  if (kind == ShapeKind::cylinder) return std::hypot(half.x, half.z);
  return kind == ShapeKind::hull && convex ? convex->radius : length(half);
}

Touch single_touch(const Vec3& normal, const Vec3& p, double gap, double margin) {
  Touch out;
  out.normal = normal;
  if (gap < margin) {
    out.points[0] = {p, gap};
    out.count = 1;
  }
  return out;
}

Vec3 lines_meet(const Vec3& pa, const Vec3& ua, const Vec3& pb, const Vec3& ub) {
  // The middle of the two lines' common perpendicular; the caller has seen to it that they are not
  // parallel.
  const double uu = dot(ua, ub);
  const Vec3 d = pb - pa;
  const double det = 1 - uu * uu;
  const double sa = (dot(ua, d) - uu * dot(ub, d)) / det;
  const double sb = (uu * dot(ua, d) - dot(ub, d)) / det;
  return (pa + ua * sa + pb + ub * sb) * 0.5;
}

// Four points of many: the deepest, the farthest from it, and the farthest on either side of the
// line through both. They span about as much as all do, which is what keeps a stack upright, and
// the solver's work is bounded.
Touch reduced(const Vec3& normal, const TouchPoint* all, int count) {
  assert(count >= 0);
  Touch out;
  out.normal = normal;
  if (count <= 4) {
    out.count = count;
    std::copy_n(all, count, out.points.begin());
    return out;
  }
  const auto keep = [&](int i) -> const TouchPoint& {
    return out.points[static_cast<std::size_t>(out.count++)] = all[i];
  };
  const Vec3 first = keep(best(all, count, [](const TouchPoint& t) { return -t.gap; })).p;
  const Vec3 second =
      keep(best(all, count, [&](const TouchPoint& t) { return squared(t.p - first); })).p;
  const Vec3 side = cross(normal, second - first);
  keep(best(all, count, [&](const TouchPoint& t) { return dot(side, t.p - first); }));
  keep(best(all, count, [&](const TouchPoint& t) { return -dot(side, t.p - first); }));
  return out;
}

namespace {

Touch touch_sphere(const Placed& ball, const Placed& b, double margin) {
  switch (b.shape.kind) {
    case ShapeKind::box:
      return touch_sphere_box(ball, b, margin);
    case ShapeKind::sphere:
      return touch_spheres(ball, b, margin);
    case ShapeKind::cylinder:
      return touch_sphere_cylinder(ball, b, margin);
    case ShapeKind::hull:
      break;
  }
  return touch_sphere_hull(ball, b, margin);
}

// A hull touches a plane with its corners alone.
Touch floor_corners(const Placed& a, double margin) {
  std::array<TouchPoint, kMostHullPoints> points;
  int count = 0;
  for (const Vec3& corner : a.shape.convex->points) {
    const Vec3 p = a.p + a.r * corner;
    if (p.z < margin) points[static_cast<std::size_t>(count++)] = {{p.x, p.y, p.z / 2}, p.z};
  }
  return reduced({0, 0, 1}, points.data(), count);
}

}  // namespace

Touch touch(const Placed& a, const Placed& b, double margin) {
  const ShapeKind ka = a.shape.kind, kb = b.shape.kind;
  if (ka == ShapeKind::box && kb == ShapeKind::box) return touch_boxes(a, b, margin);
  if (ka == ShapeKind::sphere) return touch_sphere(a, b, margin);
  if (kb != ShapeKind::sphere) return touch_hulls(a, b, margin);
  // Only one order of each pair is written out; the other is its mirror image.
  Touch out = touch_sphere(b, a, margin);
  out.normal = -out.normal;
  return out;
}

// The floor is the plane z = 0, and the normal points up from it to the body.
Touch touch_floor(const Placed& a, double margin) {
  const Vec3 up{0, 0, 1};
  if (a.shape.kind == ShapeKind::sphere) {
    const double gap = a.p.z - a.shape.half.x;
    return single_touch(up, {a.p.x, a.p.y, gap / 2}, gap, margin);
  }
  if (a.shape.kind == ShapeKind::cylinder) return touch_floor_cylinder(a, margin);
  if (a.shape.kind == ShapeKind::hull) return floor_corners(a, margin);
  PointList corners;
  for (int i = 0; i < 8; ++i) {
    const auto sign = [i](int bit) { return (i >> bit & 1) == 1 ? 1.0 : -1.0; };
    const Vec3 p = a.p + a.r * scaled(a.shape.half, {sign(0), sign(1), sign(2)});
    if (p.z < margin) corners.add({p.x, p.y, p.z / 2}, p.z);
  }
  return reduced(up, corners.points.data(), corners.count);
}

}  // namespace stig::physics
