// SPDX-License-Identifier: MIT
// Hulls against hulls, boxes and balls: separating axes and clipping, as boxes among themselves
// (box_touch.cpp), for any number of faces.
#include <algorithm>
#include <cassert>
#include <limits>

#include "physical/collision/touch_points.h"

namespace stig::physics {

namespace {

constexpr double kRounding = 1e-9;  ///< m, that arithmetic may add to a gap
/// cos(pi / 20): the ball of radius 1 fits into a prism of 20 sides in a circle of 1 / this.
constexpr double kInPrism = 0.98768834;

/// The cube of edge 2, of which every box is a stretched copy.
const Convex& cube() {
  static const std::shared_ptr<const Convex> kCube = convex_of({{1, 1, 1},
                                                                {1, 1, -1},
                                                                {1, -1, 1},
                                                                {1, -1, -1},
                                                                {-1, 1, 1},
                                                                {-1, 1, -1},
                                                                {-1, -1, 1},
                                                                {-1, -1, -1}});
  return *kCube;
}

/// A hull in its place. Its corners are moved once, since every axis asks for all of them.
struct Solid {
  const Convex& convex;
  const Placed& placed;
  std::array<Vec3, kMostHullPoints> points;

  explicit Solid(const Placed& p)
      : convex(p.shape.kind == ShapeKind::box ? cube() : *p.shape.convex), placed(p) {
    for (std::size_t i = 0; i < convex.points.size(); ++i) {
      points[i] =
          p.p + p.r * (is_box() ? scaled(convex.points[i], p.shape.half) : convex.points[i]);
    }
  }
  bool is_box() const { return placed.shape.kind == ShapeKind::box; }
  std::size_t count() const { return convex.points.size(); }
  Vec3 normal(const ConvexFace& face) const { return placed.r * face.normal; }
  double level(const ConvexFace& face, const Vec3& n) const {
    return dot(n, points[face.corners[0]]);
  }
  /// It reaches at least so far from its centre along n and against it, times |n|, which is
  /// `long_n`. When even with this bound the gap cannot beat the best one found, the corners need
  /// not be looked at. Cheap: of a cylinder sin a >= 1 - cos a, of a hull that it holds its centre.
  double least_reach(const Vec3& n, double long_n) const {
    const Mat3& r = placed.r;
    const Vec3& half = placed.shape.half;
    const double z = std::abs(dot(r.z, n));
    if (is_box()) {
      return std::abs(dot(r.x, n)) * half.x + std::abs(dot(r.y, n)) * half.y + z * half.z;
    }
    if (placed.shape.kind == ShapeKind::hull) return -std::abs(dot(r * convex.centre, n));
    return std::max(0.0, long_n - z) * (half.x * kInPrism) + z * half.z;
  }
};

/// Where a solid begins along a direction, and ends.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};
Span span_along(const Solid& solid, const Vec3& n) {
  Span out;
  for (std::size_t i = 0; i < solid.count(); ++i) {
    const double at = dot(n, solid.points[i]);
    out.low = std::min(out.low, at);
    out.high = std::max(out.high, at);
  }
  return out;
}

struct Axis {
  Vec3 n;  ///< unit, from b to a
  double gap = -std::numeric_limits<double>::infinity();
  const ConvexFace* face = nullptr;  ///< null: two edges
  bool of_a = false;                 ///< the face is
  Vec3 ua, ub;                       ///< of edges: their directions
};

/// Faces of `one`, as far as they part it from `other`.
void consider_faces(Axis& best, const Solid& one, const Solid& other, bool of_a, double margin) {
  for (const ConvexFace& face : one.convex.faces) {
    const Vec3 n = one.normal(face);
    const double level = one.level(face, n);
    const double preference = best.face == nullptr ? 0 : of_a ? 1e-9 : kFacePreference / 10;
    // The largest gap that there can be, by the bound of least_reach.
    const double most = dot(n, other.placed.p) - other.least_reach(n, 1) - level + kRounding;
    if (most <= best.gap + preference) continue;
    const double gap = span_along(other, n).low - level;
    if (gap > best.gap + preference) best = {of_a ? -n : n, gap, &face, of_a, {}, {}};
    // A gap wide enough ends it: they do not touch.
    if (best.gap >= margin) return;
  }
}

void consider_edges(Axis& best, const Solid& a, const Solid& b, double margin) {
  Axis edges;
  const double least = std::min(margin, best.gap + kFacePreference);
  const Vec3 apart = a.placed.p - b.placed.p;
  // Many pairs of hulls have hundreds of axes; memory is kept from call to call.
  thread_local std::vector<Vec3> directions;  // of b's edges
  directions.clear();
  for (const Vec3& db : b.convex.directions) directions.push_back(b.placed.r * db);
  for (const Vec3& da : a.convex.directions) {
    const Vec3 ua = a.placed.r * da;
    for (const Vec3& ub : directions) {
      const Vec3 across = cross(ua, ub);
      const double square = squared(across);
      if (square < 1e-6) continue;  // parallel edges: a face says the same
      // Most axes cannot win: told by the centres and a bound of the reach, without corners.
      const double size = std::sqrt(square), worth = std::max(least, edges.gap) - kRounding;
      if (std::abs(dot(across, apart)) - a.least_reach(across, size) -
              b.least_reach(across, size) <=
          worth * size) {
        if (edges.gap >= margin) break;
        continue;
      }
      const Vec3 n = across * (1 / size);
      const Span sa = span_along(a, n), sb = span_along(b, n);
      const double ahead = sa.low - sb.high, behind = sb.low - sa.high;
      const double gap = std::max(ahead, behind);
      // The axis is turned so that it points from b to a.
      if (gap > edges.gap) edges = {ahead >= behind ? n : -n, gap, nullptr, false, ua, ub};
      if (edges.gap >= margin) break;
    }
  }
  // As for boxes: faces win unless an edge is better by more than kFacePreference.
  if (edges.gap > best.gap + kFacePreference) best = edges;
}

/// A convex polygon of which each plane cuts one corner off and makes two.
struct CutFace {
  std::array<Vec3, 2 * kMostHullPoints> p;
  std::size_t count = 0;

  void add(const Vec3& corner) {
    assert(count < p.size());
    p[count++] = corner;
  }
};

/// Kept for their memory alone: they are large, and it takes long to clear them. Each thread has
/// its own, since worlds may step in several at once.
struct Scratch {
  CutFace polygon, next;
  std::array<TouchPoint, 2 * kMostHullPoints> points;
};

/// Leaves of the polygon the part where n·p <= limit.
void clip(CutFace*& polygon, CutFace*& next, const Vec3& n, double limit) {
  std::array<double, 2 * kMostHullPoints> beyond;
  bool whole = true;
  const std::size_t count = polygon->count;
  for (std::size_t i = 0; i < count; ++i) {
    beyond[i] = dot(n, polygon->p[i]) - limit;
    whole = whole && beyond[i] <= 0;
  }
  // Nothing is cut off by most planes.
  if (whole) return;
  next->count = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = i + 1 < count ? i + 1 : 0;
    const Vec3& p = polygon->p[i];
    const double dp = beyond[i], dq = beyond[k];
    if (dp <= 0) next->add(p);
    if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
      next->add(p + (polygon->p[k] - p) * (dp / (dp - dq)));
    }
  }
  std::swap(polygon, next);
}

/// The face of `other` that looks at `reference`'s, clipped by that one's sides.
Touch touch_face(const Vec3& normal, const Solid& reference, const ConvexFace& face,
                 const Solid& other, double margin) {
  thread_local Scratch scratch;
  const Vec3 outward = reference.normal(face);
  const ConvexFace* against = nullptr;
  double least = 2;
  // Facing each other most, decided with a margin, so that ties go to the first face.
  for (const ConvexFace& one : other.convex.faces) {
    const double facing = dot(outward, other.normal(one));
    if (facing < least - 1e-9) least = facing, against = &one;
  }
  CutFace *polygon = &scratch.polygon, *next = &scratch.next;
  polygon->count = 0;
  for (const std::uint16_t corner : against->corners) polygon->add(other.points[corner]);
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vec3 p = reference.points[face.corners[i]];
    const Vec3 q = reference.points[face.corners[i + 1 < face.corners.size() ? i + 1 : 0]];
    const Vec3 side = normalised(cross(q - p, outward));
    clip(polygon, next, side, dot(side, p));
  }
  int count = 0;
  for (std::size_t i = 0; i < polygon->count; ++i) {
    const Vec3& p = polygon->p[i];
    const double gap = dot(outward, p) - reference.level(face, outward);
    if (gap < margin) {
      scratch.points[static_cast<std::size_t>(count++)] = {p - outward * (gap / 2), gap};
    }
  }
  return reduced(normal, scratch.points.data(), count);
}

/// The middle of the edge along u that lies farthest along n.
Vec3 edge_middle(const Solid& solid, const Vec3& u, const Vec3& n) {
  Vec3 out;
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& [i, k] : solid.convex.edges) {
    const Vec3 p = solid.points[i], q = solid.points[k];
    // Parallel to u, by the sine squared.
    if (squared(cross(q - p, u)) > 1e-10 * squared(q - p)) continue;
    if (dot(n, p + q) > most) most = dot(n, p + q), out = (p + q) * 0.5;
  }
  return out;
}

Touch touch_edges(const Solid& a, const Solid& b, const Axis& axis) {
  const Vec3 pa = edge_middle(a, axis.ua, -axis.n), pb = edge_middle(b, axis.ub, axis.n);
  Touch out;
  out.normal = axis.n;
  out.points[0] = {lines_meet(pa, axis.ua, pb, axis.ub), axis.gap};
  out.count = 1;
  return out;
}

/// The point of a face that is nearest to p.
Vec3 nearest_on(const Solid& solid, const ConvexFace& face, const Vec3& p) {
  const Vec3 n = solid.normal(face);
  const Vec3 below = p - n * (dot(n, p) - solid.level(face, n));
  Vec3 best = below;
  double least = -1;  // the face's inside, until an edge is passed
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Vec3 from = solid.points[face.corners[i]];
    const Vec3 way = solid.points[face.corners[(i + 1) % face.corners.size()]] - from;
    if (dot(cross(way, below - from), n) >= 0) continue;
    // Beyond this edge: the nearest point lies on it or on another.
    const double part = std::clamp(dot(below - from, way) / squared(way), 0.0, 1.0);
    const Vec3 on = from + way * part;
    if (least < 0 || squared(on - p) < least) least = squared(on - p), best = on;
  }
  return best;
}

}  // namespace

Touch touch_hulls(const Placed& a, const Placed& b, double margin) {
  const Solid one(a), other(b);
  Axis axis;
  consider_faces(axis, one, other, true, margin);
  if (axis.gap < margin) consider_faces(axis, other, one, false, margin);
  if (axis.gap < margin) consider_edges(axis, one, other, margin);
  if (axis.gap >= margin) return {};
  if (axis.face == nullptr) return touch_edges(one, other, axis);
  return axis.of_a ? touch_face(axis.n, one, *axis.face, other, margin)
                   : touch_face(axis.n, other, *axis.face, one, margin);
}

Touch touch_sphere_hull(const Placed& ball, const Placed& hull, double margin) {
  const Solid solid(hull);
  const ConvexFace* nearest = nullptr;  // the one that the centre is least behind
  double outside = -std::numeric_limits<double>::infinity();
  // The centre is inside when it is behind all faces, so the largest of the distances tells.
  for (const ConvexFace& face : solid.convex.faces) {
    const Vec3 n = solid.normal(face);
    const double above = dot(n, ball.p) - solid.level(face, n);
    if (above > outside) outside = above, nearest = &face;
  }
  const double r = ball.shape.half.x;
  if (outside <= 0) return single_touch(solid.normal(*nearest), ball.p, outside - r, margin);
  Vec3 best;
  double least = std::numeric_limits<double>::infinity();
  for (const ConvexFace& face : solid.convex.faces) {
    const Vec3 n = solid.normal(face);
    if (dot(n, ball.p) < solid.level(face, n)) continue;
    const Vec3 p = nearest_on(solid, face, ball.p);
    if (squared(p - ball.p) < least) least = squared(p - ball.p), best = p;
  }
  const double distance = std::sqrt(least);
  // On the surface within rounding: the face's normal is what is left.
  if (!(distance > 0)) return single_touch(solid.normal(*nearest), ball.p, -r, margin);
  const Vec3 n = (ball.p - best) * (1 / distance);
  const double gap = distance - r;
  return single_touch(n, best + n * (gap / 2), gap, margin);
}

}  // namespace stig::physics
