// SPDX-License-Identifier: MIT
// Shapes as rays meet them: all are convex, so a straight line is inside one for a single
// interval, or not at all.
#pragma once

#include <optional>
#include <vector>

#include "base/vec.h"
#include "physical/collision/contact.h"
#include "physical/sensors/uses.h"
#include "robots/robot_model.h"

namespace stig::physics {

/// The points p with normal · p <= offset.
struct HalfSpace {
  Vec3 normal;
  double offset = 0;

  bool operator==(const HalfSpace&) const = default;
};

/// About its own origin. Made by the functions below.
struct SightShape {
  ShapeType type = ShapeType::box;
  Vec3 half;                      ///< half the edges of a box about the shape
  std::vector<HalfSpace> planes;  ///< of a hull

  bool operator==(const SightShape&) const = default;
};

SightShape sight_box(const Vec3& edges);
SightShape sight_sphere(double radius);
/// Along z.
SightShape sight_cylinder(double radius, double height);
/// The meeting of `planes`; `vertices` are its corners, which say how far it reaches.
SightShape sight_hull(std::vector<HalfSpace> planes, const std::vector<Vec3>& vertices);
/// The shape that contacts know, but of a cylinder: rays meet it round, not as a prism.
SightShape sight_of(const Shape& shape);

/// Where a line is inside: origin + t · direction for in <= t <= out.
struct RayCut {
  double in = 0, out = 0;
};
/// In the shape's frame; the direction need not have unit length. A line that only touches is
/// cut too. Nothing when they do not meet, or the direction is 0.
std::optional<RayCut> cut(const SightShape& shape, const Vec3& origin, const Vec3& direction);

}  // namespace stig::physics
