// SPDX-License-Identifier: MIT
// A hull is worked out once, when a shape is made, and then only moved: its faces, its edges each
// once, its edges' directions without parallels (all that separating axes are made of), and its
// mass properties as a solid of density 1 (base/hull.h).
#include "physical/collision/convex.h"

#include <algorithm>
#include <array>
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

/// A symmetric matrix with the diagonal d and, beside it, o = (yz, zx, xy).
using Square = std::array<std::array<double, 3>, 3>;
Square symmetric(const Vec3& d, const Vec3& o) {
  return {{{d.x, o.z, o.y}, {o.z, d.y, o.x}, {o.y, o.x, d.z}}};
}

/// Turns the frame about one axis so that the product of the other two is gone (Jacobi).
/// It is the smaller of the two angles that do so, by the formula that loses no digits (Golub and
/// Van Loan, Matrix Computations, on Jacobi's method).
void rotate_away(Square& m, Square& axes, std::size_t p, std::size_t q) {
  if (m[p][q] == 0) return;
  const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = m[k][p], b = m[k][q];
    m[k][p] = c * a - s * b, m[k][q] = s * a + c * b;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = m[p][k], b = m[q][k];
    m[p][k] = c * a - s * b, m[q][k] = s * a + c * b;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = axes[k][p], b = axes[k][q];
    axes[k][p] = c * a - s * b, axes[k][q] = s * a + c * b;
  }
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
  Square m = symmetric(mass.squares, mass.products), axes = symmetric({1, 1, 1}, {});
  // Three by three: a handful of sweeps converges to the last bit, twelve are plenty.
  for (int sweep = 0; sweep < 12; ++sweep) {
    rotate_away(m, axes, 0, 1);
    rotate_away(m, axes, 0, 2);
    rotate_away(m, axes, 1, 2);
  }
  const auto column = [&axes](std::size_t i) { return Vec3{axes[0][i], axes[1][i], axes[2][i]}; };
  // The third axis by the cross product, so that the frame is right-handed.
  const Vec3 x = normalised(column(0)), y = normalised(column(1));
  PrincipalHull out;
  out.volume = mass.volume;
  out.X_PB = {mass.centre, quaternion_of({x, y, cross(x, y)})};
  // Moments of inertia from second moments: about x it is the sum of those along y and z.
  out.inertia = {m[1][1] + m[2][2], m[0][0] + m[2][2], m[0][0] + m[1][1]};
  const Pose back = inverse(out.X_PB);
  for (const Vec3& p : points) out.points.push_back(back * p);
  return out;
}

}  // namespace stig::physics
