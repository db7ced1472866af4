// SPDX-License-Identifier: MIT
// The faces of a shape as convex polygons, for drawing. What is round gets facets.
#pragma once

#include <vector>

#include "physical/collision/contact.h"
#include "physical/render/uses.h"

namespace stig::physics {

struct SolidFace {
  std::vector<Vec3> corners;  ///< body frame, counter-clockwise from outside
  Vec3 normal;                ///< unit, outwards
  bool edged = true;          ///< its outline is a real edge of the body
};

std::vector<SolidFace> faces_of(const Shape& shape);

}  // namespace stig::physics
