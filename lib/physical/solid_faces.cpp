// SPDX-License-Identifier: MIT
#include "physical/solid_faces.h"

namespace stig {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kAround = 32, kUp = 16;  ///< facets of a ball

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

Vec3 on_ball(double radius, int i, int j) {
  const double a = 2 * kPi * i / kAround, b = kPi * j / kUp - kPi / 2;
  return Vec3{std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)} * radius;
}

std::vector<SolidFace> ball_faces(double radius) {
  std::vector<SolidFace> out;
  for (int j = 0; j < kUp; ++j) {
    for (int i = 0; i < kAround; ++i) {
      SolidFace face{{on_ball(radius, i, j), on_ball(radius, i + 1, j)}, {}, false};
      if (j + 1 < kUp) face.corners.push_back(on_ball(radius, i + 1, j + 1));
      if (j > 0 || j + 1 == kUp) face.corners.push_back(on_ball(radius, i, j + 1));
      if (j == 0) face.corners.push_back(on_ball(radius, i, j + 1));
      Vec3 sum;
      for (const Vec3& corner : face.corners) sum += corner;
      face.normal = normalised(sum);
      out.push_back(std::move(face));
    }
  }
  return out;
}

}  // namespace

std::vector<SolidFace> faces_of(const Shape& shape) {
  return shape.kind == ShapeKind::sphere ? ball_faces(shape.half.x) : box_faces(shape.half);
}

}  // namespace stig
