// SPDX-License-Identifier: MIT
// A convex polyhedron as contacts see it: corners, faces and edges, about its body's origin.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace stig::physics {

inline constexpr std::size_t kMostHullPoints = 64;

struct ConvexFace {
  Vec3 normal;  ///< unit, outwards
  double level = 0;
  std::vector<std::uint16_t> corners;  ///< counter-clockwise from outside
};

struct Convex {
  std::vector<Vec3> points;
  std::vector<ConvexFace> faces;
  std::vector<std::pair<std::uint16_t, std::uint16_t>> edges;
  std::vector<Vec3> directions;  ///< unit, of the edges, each once
  Vec3 half;                     ///< of the box about the origin that holds it
  double radius = 0;             ///< of the ball about the origin that holds it
  double volume = 0;
  Vec3 centre;    ///< of the solid
  Vec3 squares;   ///< integrals of x², y², z² about the centre
  Vec3 products;  ///< of yz, zx, xy
};

/// The hull of 4 to 64 finite points; null when they enclose nothing. Points within it are left
/// out.
std::shared_ptr<const Convex> convex_of(const std::vector<Vec3>& points);

/// A hull stretched along the axes. Null where the factors are not finite and positive.
std::shared_ptr<const Convex> stretched(const Convex& convex, const Vec3& by);

/// The points of a hull about its centre of mass, along its principal axes, and its moments
/// of inertia for a density of 1.
struct PrincipalHull {
  std::vector<Vec3> points;
  Pose X_PB;     ///< of the new frame in that of the points given
  Vec3 inertia;  ///< kg m² for 1 kg/m³
  double volume = 0;
};
/// The hull of points that enclose a volume, in its principal frame.
PrincipalHull principal_hull(const std::vector<Vec3>& points);

}  // namespace stig::physics
