// SPDX-License-Identifier: MIT
// Boxes that move against each other: by the separating-axis test over the whole of their way.
//
// A box that moves half its side in one step may be found deep inside another, or beyond it, where
// the axis of least overlap points out of the wrong face. So for pairs that move fast against each
// other the axis is taken that they came in by: the last of the 15 along which they begin to
// overlap.
#include <algorithm>
#include <cassert>

#include "physical/collision/touch_points.h"

namespace stig::physics {

namespace {

/// What one axis says of the way: part 0 is its beginning, 1 its end.
struct Passage {
  BoxAxis axis;            ///< as they stand now
  double least = 0;        ///< gap on the way
  double in = 0, out = 1;  ///< parts between which they overlap by more than a graze
  double closing = 0;      ///< m, along the axis
};

// Intervals along one axis: `along` is the centres' distance, `gone` what the motion adds to it,
// and the boxes overlap while |along + t · gone| < deep for t in [0, 1].
Passage passage(const Placed& a, const Placed& b, const Vec3& way, Vec3 n, int kind, double graze) {
  double along = dot(n, a.p - b.p), gone = dot(n, way);
  if (along < 0) n = -n, along = -along, gone = -gone;
  const double sum = extent(a, n) + extent(b, n), deep = sum - graze;
  Passage out;
  out.axis = {n, along - sum, kind};
  out.closing = -gone;
  const double end = along + gone;
  // The gap is least at one end of the way, or in between where the centres pass each other and
  // their distance along the axis is zero.
  out.least = (end <= 0 ? 0 : std::min(along, end)) - sum;
  // Without motion along the axis they overlap all the time or never; 2 lies beyond the way's end.
  if (std::abs(gone) < 1e-12) {
    if (along >= deep) out.in = 2;
    return out;
  }
  const double one = (deep - along) / gone, other = (-deep - along) / gone;
  out.in = std::min(one, other);
  // Boxes that are together no wider than the graze are deep enough in no part of the way.
  out.out = deep > 0 ? std::max(one, other) : -1;
  return out;
}

/// All axes of the two boxes together.
struct Way {
  Passage entry;   ///< the last along which they come to overlap
  Passage widest;  ///< along which they stay farthest apart
  double in = 0, out = 1;

  void take(const Passage& p) {
    if (p.in > in) in = p.in, entry = p;
    out = std::min(out, p.out);
    // A pair of edges has to be better by more than a face has, as in box_touch.cpp, so that
    // resting boxes keep their points.
    const double preference = p.axis.kind < 6 ? 1e-9 : kFacePreference;
    if (widest.axis.gap < -1e29 || p.least > widest.least + preference) widest = p;
  }
};

Way way_of(const Placed& a, const Placed& b, const Vec3& way, double graze) {
  Way out;
  for (int i = 0; i < 3; ++i) out.take(passage(a, b, way, a.r.column(i), i, graze));
  for (int i = 0; i < 3; ++i) out.take(passage(a, b, way, b.r.column(i), 3 + i, graze));
  for (int i = 0; i < 9; ++i) {
    const Vec3 n = cross(a.r.column(i / 3), b.r.column(i % 3));
    // Parallel edges have no axis of their own.
    if (squared(n) >= 1e-6) out.take(passage(a, b, way, normalised(n), 6 + i, graze));
  }
  return out;
}

}  // namespace

Touch touch_moving_boxes(const Placed& a, const Placed& b, const Passing& motion) {
  assert(a.shape.kind == ShapeKind::box && b.shape.kind == ShapeKind::box);
  // Rotation during the step is allowed for by a smaller graze, since the axes turn by it.
  const Way way = way_of(a, b, motion.way, kGraze - std::min(kGraze, motion.turning));
  // They pass without meeting: what there is is a gap, at its narrowest.
  if (way.in > way.out) {
    const BoxAxis& axis = way.widest.axis;
    if (way.widest.least >= motion.margin) return {};
    // Two edges are placed where they are now, not where they were farthest apart.
    if (axis.kind >= 6) return touch_boxes(a, b, motion.most);
    return touch_boxes_along(a, b, axis, motion.most);
  }
  // They overlap already: nothing is gained by looking back.
  if (way.in <= 0) return touch_boxes(a, b, motion.most);
  // Where they meet, and from there back to where they are now.
  const double part = std::max(0.0, way.entry.axis.gap / way.entry.closing);
  Placed there = a;
  there.p += motion.way * part;
  BoxAxis axis = way.entry.axis;
  axis.gap -= way.entry.closing * part;
  Touch out = touch_boxes_along(there, b, axis, motion.most);
  // The touch was found at the meeting; gap and points are taken back to the present, the points by
  // the share of the way that is a's.
  for (std::size_t i = 0; i < static_cast<std::size_t>(out.count); ++i) {
    out.points[i].gap += way.entry.closing * part;
    out.points[i].p -= motion.way * (part * motion.share);
  }
  return out;
}

}  // namespace stig::physics
