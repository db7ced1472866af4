// SPDX-License-Identifier: MIT
// Convex faces with outward normals, corners counter-clockwise as seen from outside. What is round
// gets facets that are drawn without edges (`edged`), each with the normal of its middle.
#include "physical/render/solid_faces.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace stig::physics {

namespace {

constexpr int kAround = 32, kUp = 16;  ///< facets of what is round

/// One side of a box: axis 0 to 2, sign ±1.
SolidFace box_face(const Vec3& half, int axis, double sign) {
  const Mat3 axes;
  const Vec3 n = axes.column(axis) * sign;
  // With u × v = n, so that the corners go round counter-clockwise.
  const Vec3 u = axes.column((axis + 1) % 3), v = cross(n, u);
  SolidFace face{{}, n, true};
  for (const auto& [a, b] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
    face.corners.push_back(scaled(n + u * a + v * b, half));
  }
  return face;
}

std::vector<SolidFace> box_faces(const Vec3& half) {
  std::vector<SolidFace> out;
  for (int axis = 0; axis < 3; ++axis) {
    out.push_back(box_face(half, axis, 1));
    out.push_back(box_face(half, axis, -1));
  }
  return out;
}

// By longitude i and latitude j, from the lower pole up.
Vec3 on_ball(double radius, int i, int j) {
  const double a = 2 * std::numbers::pi * i / kAround,
               b = std::numbers::pi * j / kUp - std::numbers::pi / 2;
  return Vec3{std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)} * radius;
}

std::vector<SolidFace> ball_faces(double radius) {
  std::vector<SolidFace> out;
  for (int j = 0; j < kUp; ++j) {
    for (int i = 0; i < kAround; ++i) {
      SolidFace face{{on_ball(radius, i, j), on_ball(radius, i + 1, j)}, {}, false};
      // The rows at the poles are triangles; all others have four corners.
      if (j + 1 < kUp) face.corners.push_back(on_ball(radius, i + 1, j + 1));
      if (j > 0 || j + 1 == kUp) face.corners.push_back(on_ball(radius, i, j + 1));
      if (j == 0) face.corners.push_back(on_ball(radius, i, j + 1));
      // The direction of the middle serves as the normal of the whole facet.
      Vec3 sum;
      for (const Vec3& corner : face.corners) sum += corner;
      face.normal = normalised(sum);
      out.push_back(std::move(face));
    }
  }
  return out;
}

std::vector<SolidFace> cylinder_faces(double radius, double half) {
  std::vector<SolidFace> out;
  SolidFace top{{}, {0, 0, 1}, true}, bottom{{}, {0, 0, -1}, true};
  const auto rim = [&](int i, double z) {
    const double a = 2 * std::numbers::pi * i / kAround;
    return Vec3{radius * std::cos(a), radius * std::sin(a), z};
  };
  for (int i = 0; i < kAround; ++i) {
    top.corners.push_back(rim(i, half));
    // Backwards, since the bottom is seen from below.
    bottom.corners.push_back(rim(-i, -half));
    const double a = 2 * std::numbers::pi * (i + 0.5) / kAround;
    out.push_back({{rim(i, -half), rim(i + 1, -half), rim(i + 1, half), rim(i, half)},
                   {std::cos(a), std::sin(a), 0},
                   false});
  }
  out.push_back(std::move(top));
  out.push_back(std::move(bottom));
  return out;
}

std::vector<SolidFace> hull_solid(const Convex& hull) {
  std::vector<SolidFace> out;
  for (const ConvexFace& face : hull.faces) {
    SolidFace solid{{}, face.normal, true};
    for (const std::uint16_t corner : face.corners) solid.corners.push_back(hull.points[corner]);
    out.push_back(std::move(solid));
  }
  return out;
}

}  // namespace

std::vector<SolidFace> faces_of(const Shape& shape) {
  assert(shape.kind != ShapeKind::hull || shape.convex != nullptr);
  switch (shape.kind) {
    case ShapeKind::sphere:
      return ball_faces(shape.half.x);
    case ShapeKind::cylinder:
      return cylinder_faces(shape.half.x, shape.half.z);
    case ShapeKind::hull:
      return hull_solid(*shape.convex);
    case ShapeKind::box:
      break;
  }
  return box_faces(shape.half);
}

}  // namespace stig::physics
