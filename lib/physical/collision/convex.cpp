// SPDX-License-Identifier: MIT
// A hull is worked out once, when a shape is made, and then only moved: its faces, its edges each
// once, its edges' directions without parallels (all that separating axes are made of), and its
// mass properties as a solid of density 1 (base/hull.h).
#include "physical/collision/convex.h"

#include <algorithm>
#include <cassert>

#include "base/hull.h"

namespace stig::physics {

namespace {

void add_edge(Convex& out, std::uint16_t a, std::uint16_t b) {
  // Faces go round counter-clockwise, so each edge comes up once in either direction.
  if (a > b) return;  // seen from the face on its other side
  out.edges.emplace_back(a, b);
  const Vec3 u = normalised(out.points[b] - out.points[a]);
  // The twelve edges of a box have three directions.
  const auto parallel = [&u](const Vec3& v) { return squared(cross(u, v)) < 1e-12; };
  if (std::none_of(out.directions.begin(), out.directions.end(), parallel)) {
    out.directions.push_back(u);
  }
}

/// Copies the corners that some face has; says where each went. Points within the hull, or within a
/// face, are no corners, and nobody needs them.
std::vector<std::uint16_t> take_corners(const std::vector<HullFace>& faces,
                                        const std::vector<Vec3>& points, Convex& out) {
  std::vector<bool> used(points.size(), false);
  for (const HullFace& face : faces) {
    for (const std::size_t corner : face.corners) used[corner] = true;
  }
  std::vector<std::uint16_t> numbers(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!used[i]) continue;
    numbers[i] = static_cast<std::uint16_t>(out.points.size());
    out.points.push_back(points[i]);
  }
  return numbers;
}

void take_face(const HullFace& face, const std::vector<std::uint16_t>& numbers, Convex& out) {
  assert(face.corners.size() >= 3);
  ConvexFace taken{face.normal, 0, {}};
  for (const std::size_t corner : face.corners) taken.corners.push_back(numbers[corner]);
  taken.level = dot(face.normal, out.points[taken.corners[0]]);
  for (std::size_t i = 0; i < taken.corners.size(); ++i) {
    add_edge(out, taken.corners[i], taken.corners[(i + 1) % taken.corners.size()]);
  }
  out.faces.push_back(std::move(taken));
}

void measure(Convex& out) {
  for (const Vec3& p : out.points) {
    out.half = {std::max(out.half.x, std::abs(p.x)), std::max(out.half.y, std::abs(p.y)),
                std::max(out.half.z, std::abs(p.z))};
    out.radius = std::max(out.radius, length(p));
  }
  const HullMass mass = hull_mass(out.points);
  out.volume = mass.volume;
  out.centre = mass.centre;
  out.squares = mass.squares;
  out.products = mass.products;
}

}  // namespace

std::shared_ptr<const Convex> convex_of(const std::vector<Vec3>& points) {
  // The bound keeps scratch buffers of fixed size; points may be a user's.
  if (points.size() < 4 || points.size() > kMostHullPoints) return nullptr;
  if (!std::all_of(points.begin(), points.end(), is_finite)) return nullptr;
  const std::vector<HullFace> faces = hull_faces(points);
  if (faces.empty()) return nullptr;
  auto out = std::make_shared<Convex>();
  const std::vector<std::uint16_t> numbers = take_corners(faces, points, *out);
  for (const HullFace& face : faces) take_face(face, numbers, *out);
  measure(*out);
  return out;
}

std::shared_ptr<const Convex> stretched(const Convex& convex, const Vec3& by) {
  if (!is_finite(by) || !(std::min({by.x, by.y, by.z}) > 0)) return nullptr;
  auto out = std::make_shared<Convex>(convex);
  out->radius = 0;
  for (Vec3& p : out->points) {
    p = scaled(p, by);
    out->radius = std::max(out->radius, length(p));
  }
  for (ConvexFace& face : out->faces) {
    // Normals go by the inverse of the stretch, unlike directions and points.
    face.normal = normalised(scaled(face.normal, {1 / by.x, 1 / by.y, 1 / by.z}));
    face.level = dot(face.normal, out->points[face.corners[0]]);
  }
  for (Vec3& direction : out->directions) direction = normalised(scaled(direction, by));
  out->half = scaled(out->half, by);
  // A volume grows by the product, second moments by the squares besides.
  const double larger = by.x * by.y * by.z;
  out->volume *= larger;
  out->centre = scaled(out->centre, by);
  out->squares = scaled(out->squares, scaled(by, by)) * larger;
  out->products = scaled(out->products, {by.y * by.z, by.z * by.x, by.x * by.y}) * larger;
  return out;
}

PrincipalHull principal_hull(const std::vector<Vec3>& points) {
  const HullMass mass = hull_mass(points);
  assert(mass.volume > 0);
  const PrincipalFrame frame = principal_frame(mass.squares, mass.products);
  PrincipalHull out;
  out.volume = mass.volume;
  out.X_PB = {mass.centre, frame.q};
  // Moments of inertia from second moments: about x it is the sum of those along y and z.
  const Vec3& m = frame.squares;
  out.inertia = {m.y + m.z, m.x + m.z, m.x + m.y};
  const Pose back = inverse(out.X_PB);
  for (const Vec3& p : points) out.points.push_back(back * p);
  return out;
}

}  // namespace stig::physics
