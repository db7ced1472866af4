// SPDX-License-Identifier: MIT
#include "base/hull.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <set>

namespace stig {
namespace {

std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> out;
  for (const double x : {low.x, high.x}) {
    for (const double y : {low.y, high.y}) {
      for (const double z : {low.z, high.z}) out.push_back({x, y, z});
    }
  }
  return out;
}

}  // namespace

TEST_CASE("the hull of a box's corners, of points inside it and on its faces") {
  std::vector<Vec3> points = box_corners({1, 2, 3}, {2, 4, 6});
  for (const Vec3& extra : {Vec3{1.5, 3, 4}, {1, 3, 4}, {1.5, 2, 3}, {1, 2, 3}}) {
    points.push_back(extra);
  }
  const auto faces = hull_faces(points);
  CHECK(faces.size() == 6);
  for (const HullFace& face : faces) {
    CHECK(face.corners.size() == 4);
    // Counter-clockwise from outside, and outwards.
    const Vec3 a = points[face.corners[0]], b = points[face.corners[1]],
               c = points[face.corners[2]];
    CHECK(dot(cross(b - a, c - b), face.normal) > 0);
    CHECK(dot(a - Vec3{1.5, 3, 4.5}, face.normal) > 0);
  }
  const HullMass mass = hull_mass(points);
  CHECK(mass.volume == doctest::Approx(6));
  CHECK(length(mass.centre - Vec3{1.5, 3, 4.5}) < 1e-9);
  // Edges 1, 2, 3: volume times edge² / 12.
  CHECK(length(mass.squares - Vec3{0.5, 2, 4.5}) < 1e-9);
}

TEST_CASE("a tetrahedron, turned and moved") {
  const Pose X{{7, -3, 2}, rotation({0.3, -0.8, 1.1})};
  std::vector<Vec3> points;
  for (const Vec3& p : {Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) points.push_back(X * p);
  CHECK(hull_faces(points).size() == 4);
  const HullMass mass = hull_mass(points);
  CHECK(mass.volume == doctest::Approx(1.0 / 6));
  CHECK(length(mass.centre - X * Vec3{0.25, 0.25, 0.25}) < 1e-9);
}

TEST_CASE("a ball of points: every face is outside, every point in one") {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double z = (2.0 * i + 1) / 40 - 1, a = 2.4 * i, r = std::sqrt(1 - z * z);
    points.push_back({r * std::cos(a), r * std::sin(a), z});
  }
  std::set<std::size_t> used;
  std::size_t edges = 0;
  const auto faces = hull_faces(points);
  for (const HullFace& face : faces) {
    used.insert(face.corners.begin(), face.corners.end());
    edges += face.corners.size();
    for (const Vec3& p : points) CHECK(dot(p - points[face.corners[0]], face.normal) < 1e-9);
  }
  CHECK(used.size() == 40);
  CHECK(40 + faces.size() == edges / 2 + 2);  // Euler
}

TEST_CASE("flat points have no hull") {
  CHECK(hull_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).empty());
  CHECK(hull_faces({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).empty());
  CHECK(hull_mass({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).volume == 0);
}

}  // namespace stig
