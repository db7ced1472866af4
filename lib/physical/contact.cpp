// SPDX-License-Identifier: MIT
#include "physical/contact.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "physical/touch_points.h"

namespace stig {

namespace {

/// Index of the point for which `score` is largest.
template <class Score>
int best(const PointList& all, Score score) {
  int at = 0;
  double most = score(all.points[0]);
  for (int i = 1; i < all.count; ++i) {
    const double value = score(all.points[static_cast<std::size_t>(i)]);
    if (value > most) std::tie(most, at) = std::pair(value, i);
  }
  return at;
}

Touch single(const Vec3& normal, const Vec3& p, double gap, double margin) {
  Touch out;
  out.normal = normal;
  if (gap < margin) {
    out.points[0] = {p, gap};
    out.count = 1;
  }
  return out;
}

Touch touch_spheres(const Placed& a, const Placed& b, double margin) {
  const Vec3 d = a.p - b.p;
  const double distance = length(d);
  const Vec3 n = distance > 0 ? d * (1 / distance) : Vec3{0, 0, 1};
  const double gap = distance - a.shape.half.x - b.shape.half.x;
  return single(n, b.p + n * (b.shape.half.x + gap / 2), gap, margin);
}

/// The sphere is a.
Touch touch_sphere_box(const Placed& a, const Placed& b, double margin) {
  const Vec3 h = b.shape.half;
  const Vec3 c = b.r.transposed(a.p - b.p);
  const Vec3 nearest{std::clamp(c.x, -h.x, h.x), std::clamp(c.y, -h.y, h.y),
                     std::clamp(c.z, -h.z, h.z)};
  const double outside = length(c - nearest);
  if (outside > 0) {
    const Vec3 n = b.r * ((c - nearest) * (1 / outside));
    const double gap = outside - a.shape.half.x;
    return single(n, b.p + b.r * nearest + n * (gap / 2), gap, margin);
  }
  // The centre is inside: out through the nearest face.
  const std::array<double, 3> depth{h.x - std::abs(c.x), h.y - std::abs(c.y), h.z - std::abs(c.z)};
  const auto axis = static_cast<int>(std::min_element(depth.begin(), depth.end()) - depth.begin());
  const double side = axis == 0 ? c.x : axis == 1 ? c.y : c.z;
  const Vec3 n = b.r.column(axis) * (side < 0 ? -1.0 : 1.0);
  return single(n, a.p, -depth[static_cast<std::size_t>(axis)] - a.shape.half.x, margin);
}

}  // namespace

Touch reduced(const Vec3& normal, const PointList& all) {
  Touch out;
  out.normal = normal;
  if (all.count <= 4) {
    out.count = all.count;
    std::copy_n(all.points.begin(), all.count, out.points.begin());
    return out;
  }
  const auto keep = [&](int i) -> const TouchPoint& {
    return out.points[static_cast<std::size_t>(out.count++)] =
               all.points[static_cast<std::size_t>(i)];
  };
  const Vec3 first = keep(best(all, [](const TouchPoint& t) { return -t.gap; })).p;
  const Vec3 second = keep(best(all, [&](const TouchPoint& t) { return squared(t.p - first); })).p;
  const Vec3 side = cross(normal, second - first);
  keep(best(all, [&](const TouchPoint& t) { return dot(side, t.p - first); }));
  keep(best(all, [&](const TouchPoint& t) { return -dot(side, t.p - first); }));
  return out;
}

Touch touch(const Placed& a, const Placed& b, double margin) {
  const bool box_a = a.shape.kind == ShapeKind::box, box_b = b.shape.kind == ShapeKind::box;
  if (box_a && box_b) return touch_boxes(a, b, margin);
  if (!box_a && !box_b) return touch_spheres(a, b, margin);
  if (!box_a) return touch_sphere_box(a, b, margin);
  Touch out = touch_sphere_box(b, a, margin);
  out.normal = -out.normal;
  return out;
}

Touch touch_floor(const Placed& a, double margin) {
  const Vec3 up{0, 0, 1};
  if (a.shape.kind == ShapeKind::sphere) {
    const double gap = a.p.z - a.shape.half.x;
    return single(up, {a.p.x, a.p.y, gap / 2}, gap, margin);
  }
  PointList corners;
  for (int i = 0; i < 8; ++i) {
    const auto sign = [i](int bit) { return (i >> bit & 1) == 1 ? 1.0 : -1.0; };
    const Vec3 p = a.p + a.r * scaled(a.shape.half, {sign(0), sign(1), sign(2)});
    if (p.z < margin) corners.add({p.x, p.y, p.z / 2}, p.z);
  }
  return reduced(up, corners);
}

}  // namespace stig
