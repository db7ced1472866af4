// SPDX-License-Identifier: MIT
// Slabs, balls and half-spaces are each cut in an interval of the line's parameter; a convex shape
// is their meeting, and its cut the intersection of intervals (Kay and Kajiya 1986 for boxes).
// Distances are in lengths of the direction, so callers need no unit vector.
#include "physical/sensors/sight_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::physics {

namespace {

// The neutral element of `both`, and an interval that stays empty however it is cut.
constexpr RayCut kEverywhere{-INFINITY, INFINITY};
constexpr RayCut kNowhere{INFINITY, -INFINITY};

RayCut both(const RayCut& a, const RayCut& b) {
  return {std::max(a.in, b.in), std::min(a.out, b.out)};
}

/// Where |o + t d| <= h.
RayCut slab(double o, double d, double h) {
  // A parallel line would divide 0 by 0.
  if (d == 0) return std::abs(o) <= h ? kEverywhere : kNowhere;
  const double a = (-h - o) / d, b = (h - o) / d;
  return {std::min(a, b), std::max(a, b)};
}

/// Where |o + t d| <= r, for vectors given by their products. It serves spheres and a cylinder's
/// round side, which differ in how many coordinates their products take.
RayCut ball(double oo, double od, double dd, double r) {
  const double c = oo - r * r;
  if (dd == 0) return c <= 0 ? kEverywhere : kNowhere;
  const double root = od * od - dd * c;
  if (root < 0) return kNowhere;
  const double s = std::sqrt(root);
  return {(-od - s) / dd, (-od + s) / dd};
}

RayCut cut_box(const Vec3& half, const Vec3& o, const Vec3& d) {
  return both(both(slab(o.x, d.x, half.x), slab(o.y, d.y, half.y)), slab(o.z, d.z, half.z));
}

RayCut cut_cylinder(const Vec3& half, const Vec3& o, const Vec3& d) {
  const RayCut round =
      ball(o.x * o.x + o.y * o.y, o.x * d.x + o.y * d.y, d.x * d.x + d.y * d.y, half.x);
  return both(round, slab(o.z, d.z, half.z));
}

RayCut cut_hull(const std::vector<HalfSpace>& planes, const Vec3& o, const Vec3& d) {
  // Clip a line by planes (Cyrus and Beck 1978): planes that it rises through bound where it
  // leaves, others where it enters.
  RayCut out = kEverywhere;
  for (const HalfSpace& h : planes) {
    const double above = dot(h.normal, o) - h.offset, rise = dot(h.normal, d);
    if (rise == 0 && above > 0) return kNowhere;
    if (rise > 0) out.out = std::min(out.out, -above / rise);
    if (rise < 0) out.in = std::max(out.in, -above / rise);
  }
  return out;
}

}  // namespace

SightShape sight_box(const Vec3& edges) { return {ShapeType::box, edges * 0.5, {}}; }

SightShape sight_sphere(double radius) { return {ShapeType::sphere, {radius, radius, radius}, {}}; }

SightShape sight_cylinder(double radius, double height) {
  return {ShapeType::cylinder, {radius, radius, height / 2}, {}};
}

SightShape sight_hull(std::vector<HalfSpace> planes, const std::vector<Vec3>& vertices) {
  Vec3 half;
  for (const Vec3& v : vertices) {
    half = {std::max(half.x, std::abs(v.x)), std::max(half.y, std::abs(v.y)),
            std::max(half.z, std::abs(v.z))};
  }
  return {ShapeType::hull, half, std::move(planes)};
}

SightShape sight_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::box:
      return sight_box(shape.half * 2);
    case ShapeKind::sphere:
      return sight_sphere(shape.half.x);
    case ShapeKind::cylinder:
      return sight_cylinder(shape.half.x, shape.half.z * 2);
    case ShapeKind::hull:
      break;
  }
  assert(shape.convex);  // no world takes a hull without extent
  std::vector<HalfSpace> planes;
  for (const ConvexFace& face : shape.convex->faces) planes.push_back({face.normal, face.level});
  return sight_hull(std::move(planes), shape.convex->points);
}

std::optional<RayCut> cut(const SightShape& shape, const Vec3& origin, const Vec3& direction) {
  if (!(squared(direction) > 0)) return std::nullopt;
  RayCut out;
  switch (shape.type) {
    case ShapeType::box:
      out = cut_box(shape.half, origin, direction);
      break;
    case ShapeType::sphere:
      out = ball(squared(origin), dot(origin, direction), squared(direction), shape.half.x);
      break;
    case ShapeType::cylinder:
      out = cut_cylinder(shape.half, origin, direction);
      break;
    case ShapeType::hull:
      // The box cuts first so that a hull whose planes leave a side open stays bounded.
      out = cut_box(shape.half, origin, direction);
      if (out.in <= out.out) out = both(out, cut_hull(shape.planes, origin, direction));
      break;
  }
  if (!(out.in <= out.out)) return std::nullopt;
  return out;
}

}  // namespace stig::physics
