// SPDX-License-Identifier: MIT
// From the points of a clipped face to the four that a Touch keeps. Used by contact.cpp
// and box_touch.cpp.
#pragma once

#include "physical/contact.h"

namespace stig {

/// Two convex quadrilaterals meet in at most eight corners.
struct PointList {
  std::array<TouchPoint, 16> points;
  int count = 0;

  void add(const Vec3& p, double gap) { points[static_cast<std::size_t>(count++)] = {p, gap}; }
};

/// All when there are four or fewer; otherwise the deepest and those that span most.
Touch reduced(const Vec3& normal, const PointList& all);

Touch touch_boxes(const Placed& a, const Placed& b, double margin);

}  // namespace stig
