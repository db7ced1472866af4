// SPDX-License-Identifier: MIT
// The convex hull of a few points, by looking at every plane through three of them: slow and
// plain, for bodies of some dozen corners.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vec.h"

namespace stig {

struct HullFace {
  std::vector<std::size_t> corners;  ///< places in the list of points, counter-clockwise outside
  Vec3 normal;                       ///< unit, outwards
};

/// Faces of several triangles in one plane are one. Points inside, or in the middle of a face,
/// are in none. Empty when the points lie in one plane.
std::vector<HullFace> hull_faces(const std::vector<Vec3>& points);

/// Mass properties of a solid of density 1.
struct HullMass {
  double volume = 0;
  Vec3 centre;
  Vec3 squares;   ///< integrals of x², y², z² about the centre
  Vec3 products;  ///< of yz, zx, xy, likewise
};
HullMass hull_mass(const std::vector<Vec3>& points);

/// Axes along which the products of a distribution of mass vanish.
struct PrincipalFrame {
  Quat q;        ///< of these axes in the frame of what is given
  Vec3 squares;  ///< integrals of x², y², z² along them
};
PrincipalFrame principal_frame(const Vec3& squares, const Vec3& products);

}  // namespace stig
