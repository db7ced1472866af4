// SPDX-License-Identifier: MIT
// The separating-axis test for two oriented boxes: 15 axes (three faces each, nine pairs of edges),
// of which the one with the largest gap is the normal; then the incident face is clipped by the
// reference face's sides (Sutherland and Hodgman 1974). Which axis wins must not flicker from step
// to step, or points of a resting stack would lose their accumulated impulses: hence the
// preferences, a's faces before b's before edges.
#include <algorithm>
#include <cassert>

#include "physical/collision/touch_points.h"

namespace stig::physics {

namespace {

double half_of(const Placed& box, int i) {
  return i == 0 ? box.shape.half.x : i == 1 ? box.shape.half.y : box.shape.half.z;
}

/// Takes the axis when it parts the boxes by `preference` more than the best so far.
void consider(BoxAxis& best, const Placed& a, const Placed& b, Vec3 n, int kind,
              double preference) {
  const double along = dot(n, a.p - b.p);
  if (along < 0) n = -n;
  const double gap = std::abs(along) - extent(a, n) - extent(b, n);
  if (gap > best.gap + preference) best = {n, gap, kind};
}

/// Whether the other box lies beyond two of this one's faces, but for a graze. Then they pass each
/// other edge on: no face of either lies against the other, and a contact along a face's normal
/// would catch at an edge that is not there.
bool beyond_edge(const Placed& box, const Placed& other) {
  int beyond = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 n = box.r.column(i);
    const double gap = std::abs(dot(n, box.p - other.p)) - half_of(box, i) - extent(other, n);
    beyond += gap > -kGraze ? 1 : 0;
  }
  return beyond > 1;
}

/// The best axis, or one with a gap of at least `margin` as soon as it is found.
BoxAxis separating_axis(const Placed& a, const Placed& b, double margin) {
  BoxAxis best;
  for (int i = 0; i < 3 && best.gap < margin; ++i) {
    // The first axis needs no advantage; among a's own faces only rounding is to be outdone.
    consider(best, a, b, a.r.column(i), i, i == 0 ? 0 : 1e-9);
  }
  for (int i = 0; i < 3 && best.gap < margin; ++i) {
    consider(best, a, b, b.r.column(i), 3 + i, kFacePreference / 10);
  }
  BoxAxis edges;
  for (int i = 0; i < 9 && best.gap < margin; ++i) {
    const Vec3 n = cross(a.r.column(i / 3), b.r.column(i % 3));
    if (squared(n) < 1e-6) continue;  // parallel edges: a face says the same
    consider(edges, a, b, normalised(n), 6 + i, 0);
    if (edges.gap > best.gap + kFacePreference) best = edges;
  }
  return best;
}

/// The quadrilateral of a box's face whose outward normal lies most against n. That is decided with
/// a margin, so that a tie always goes to the lower axis.
std::array<Vec3, 4> face_against(const Placed& box, const Vec3& n) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(dot(n, box.r.column(i))) > std::abs(dot(n, box.r.column(axis))) + 1e-9) axis = i;
  }
  const double side = dot(n, box.r.column(axis)) > 0 ? -1 : 1;
  const Vec3 centre = box.p + box.r.column(axis) * (side * half_of(box, axis));
  const int iu = (axis + 1) % 3, iv = (axis + 2) % 3;
  const Vec3 u = box.r.column(iu) * half_of(box, iu), v = box.r.column(iv) * half_of(box, iv);
  return {centre + u + v, centre - u + v, centre - u - v, centre + u - v};
}

/// A convex polygon; clipping a quadrilateral by four planes leaves at most eight corners.
struct Polygon {
  std::array<Vec3, 10> p;
  std::size_t count = 0;
};

/// The part of the polygon where n·p <= limit.
Polygon clipped(const Polygon& in, const Vec3& n, double limit) {
  Polygon out;
  // One pass of Sutherland and Hodgman; corners on the plane belong to the inside, so that they are
  // not made twice.
  for (std::size_t i = 0; i < in.count; ++i) {
    const Vec3& p = in.p[i];
    const Vec3& q = in.p[i + 1 < in.count ? i + 1 : 0];
    const double dp = dot(n, p) - limit, dq = dot(n, q) - limit;
    if (dp <= 0) out.p[out.count++] = p;
    if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
      out.p[out.count++] = p + (q - p) * (dp / (dp - dq));
    }
    assert(out.count <= out.p.size());
  }
  return out;
}

/// Clips the face of `other` that looks at `reference`'s face number `axis`, whose outward
/// normal is `outward`. Gaps are along it.
PointList face_points(const Placed& reference, int axis, const Vec3& outward, const Placed& other,
                      double margin) {
  const std::array<Vec3, 4> face = face_against(other, outward);
  // Clipping happens in the plane of the other's face; points are put midway in the gap.
  Polygon polygon;
  polygon.count = 4;
  std::copy(face.begin(), face.end(), polygon.p.begin());
  for (int k = 1; k < 3; ++k) {
    const int i = (axis + k) % 3;
    const Vec3 side = reference.r.column(i);
    const double at = dot(side, reference.p), half = half_of(reference, i);
    polygon = clipped(polygon, side, at + half);
    polygon = clipped(polygon, -side, half - at);
  }
  // The reference face's plane.
  const double level = dot(outward, reference.p) + half_of(reference, axis);
  PointList out;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const double gap = dot(outward, polygon.p[i]) - level;
    if (gap < margin) out.add(polygon.p[i] - outward * (gap / 2), gap);
  }
  return out;
}

/// The middle of the box's edge along `axis` that lies farthest along n. One point of an edge
/// suffices, since it is the lines through both edges that are brought together, not the segments.
Vec3 edge_middle(const Placed& box, int axis, const Vec3& n) {
  Vec3 p = box.p;
  for (int k = 1; k < 3; ++k) {
    const int i = (axis + k) % 3;
    const Vec3 column = box.r.column(i);
    p += column * (dot(n, column) > 0 ? half_of(box, i) : -half_of(box, i));
  }
  return p;
}

/// Midway between the two edges where they are nearest.
Vec3 edges_meet(const Placed& a, const Placed& b, const BoxAxis& axis) {
  const int ia = (axis.kind - 6) / 3, ib = (axis.kind - 6) % 3;
  const Vec3 pa = edge_middle(a, ia, -axis.n), pb = edge_middle(b, ib, axis.n);
  const Vec3 ua = a.r.column(ia), ub = b.r.column(ib);
  return lines_meet(pa, ua, pb, ub);
}

}  // namespace

double extent(const Placed& box, const Vec3& n) {
  return std::abs(dot(n, box.r.x)) * box.shape.half.x +
         std::abs(dot(n, box.r.y)) * box.shape.half.y +
         std::abs(dot(n, box.r.z)) * box.shape.half.z;
}

Touch touch_boxes_along(const Placed& a, const Placed& b, const BoxAxis& axis, double margin) {
  if (axis.kind < 6) {
    const PointList all = axis.kind < 3 ? face_points(a, axis.kind, -axis.n, b, margin)
                                        : face_points(b, axis.kind - 3, axis.n, a, margin);
    return reduced(axis.n, all.points.data(), all.count);
  }
  Touch out;
  out.normal = axis.n;
  out.points[0] = {edges_meet(a, b, axis), axis.gap};
  out.count = 1;
  return out;
}

Touch touch_boxes(const Placed& a, const Placed& b, double margin) {
  const BoxAxis axis = separating_axis(a, b, margin);
  if (axis.gap >= margin) return {};
  // A gap along a face's normal, or an overlap no deeper than a graze, is no contact where the
  // boxes pass each other edge on.
  if (axis.kind < 6 && axis.gap > -kGraze && (beyond_edge(a, b) || beyond_edge(b, a))) return {};
  return touch_boxes_along(a, b, axis, margin);
}

}  // namespace stig::physics
