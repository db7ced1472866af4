// SPDX-License-Identifier: MIT
// Boxes that move against each other: by the separating-axis test over the whole of their way.
#include <algorithm>

#include "physical/collision/touch_points.h"

namespace stig {

namespace {

/// What one axis says of the way: part 0 is its beginning, 1 its end.
struct Passage {
  BoxAxis axis;            ///< as they stand now
  double least = 0;        ///< gap on the way
  double in = 0, out = 1;  ///< parts between which they overlap by more than a graze
  double closing = 0;      ///< m, along the axis
};

Passage passage(const Placed& a, const Placed& b, const Vec3& way, Vec3 n, int kind, double graze) {
  double along = dot(n, a.p - b.p), gone = dot(n, way);
  if (along < 0) n = -n, along = -along, gone = -gone;
  const double sum = extent(a, n) + extent(b, n), deep = sum - graze;
  Passage out;
  out.axis = {n, along - sum, kind};
  out.closing = -gone;
  const double end = along + gone;
  out.least = (end <= 0 ? 0 : std::min(along, end)) - sum;
  if (std::abs(gone) < 1e-12) {
    if (along >= deep) out.in = 2;
    return out;
  }
  const double one = (deep - along) / gone, other = (-deep - along) / gone;
  out.in = std::min(one, other);
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
    if (squared(n) >= 1e-6) out.take(passage(a, b, way, normalised(n), 6 + i, graze));
  }
  return out;
}

}  // namespace

Touch touch_moving_boxes(const Placed& a, const Placed& b, const Passing& motion) {
  const Way way = way_of(a, b, motion.way, kGraze - std::min(kGraze, motion.turning));
  if (way.in > way.out) {
    const BoxAxis& axis = way.widest.axis;
    if (way.widest.least >= motion.margin) return {};
    if (axis.kind >= 6) return touch_boxes(a, b, motion.most);
    return touch_boxes_along(a, b, axis, motion.most);
  }
  if (way.in <= 0) return touch_boxes(a, b, motion.most);
  // Where they meet, and from there back to where they are now.
  const double part = std::max(0.0, way.entry.axis.gap / way.entry.closing);
  Placed there = a;
  there.p += motion.way * part;
  BoxAxis axis = way.entry.axis;
  axis.gap -= way.entry.closing * part;
  Touch out = touch_boxes_along(there, b, axis, motion.most);
  for (std::size_t i = 0; i < static_cast<std::size_t>(out.count); ++i) {
    out.points[i].gap += way.entry.closing * part;
    out.points[i].p -= motion.way * (part * motion.share);
  }
  return out;
}

}  // namespace stig
