// SPDX-License-Identifier: MIT
#include "urdf/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"

namespace stig::urdf {

namespace {

constexpr double kKernelSide = 0.002;   ///< m
constexpr double kShellShare = 1e-9;    ///< of the mass, of each solid beside a kernel
constexpr double kNearMiddle = 1e-6;    ///< m: that near, the solid's middle is that of the mass
constexpr double kNearAxes = 1e-5;      ///< products, as a share of the largest moment
constexpr double kLeastMoment = 1e-12;  ///< kg·m², as robot files have it

using Rows = std::array<std::array<double, 3>, 3>;

Rows rows_of(const Mat3& m) {
  return {{{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}}};
}

/// Turns a and v in the plane of p and q so that a[p][q] is 0.
void rotate_away(Rows& a, Rows& v, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double kp = a[k][p], kq = a[k][q];
    a[k][p] = c * kp - s * kq;
    a[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double pk = a[p][k], qk = a[q][k];
    a[p][k] = c * pk - s * qk;
    a[q][k] = s * pk + c * qk;
    const double vp = v[k][p], vq = v[k][q];
    v[k][p] = c * vp - s * vq;
    v[k][q] = s * vp + c * vq;
  }
}

Mat3 sum(const Mat3& a, const Mat3& b, double factor) {
  return {a.x + b.x * factor, a.y + b.y * factor, a.z + b.z * factor};
}

/// Of a point mass at d.
Mat3 point_moments(double mass, const Vec3& d) {
  const auto column = [&](const Vec3& e, double part) { return (e * dot(d, d) - d * part) * mass; };
  return {column({1, 0, 0}, d.x), column({0, 1, 0}, d.y), column({0, 0, 1}, d.z)};
}

BodyModel solid_body(const Solid& solid, double mass) {
  BodyModel out;
  out.shape = solid.shape;
  out.size = solid.size;
  out.mass = mass;
  return out;
}

/// Rounding of flat bodies: no moment is above the sum of the others, none next to nothing.
Vec3 possible(Vec3 m) {
  for (double* one : {&m.x, &m.y, &m.z}) *one = std::max(*one, kLeastMoment);
  double* const most = std::max({&m.x, &m.y, &m.z}, [](auto* a, auto* b) { return *a < *b; });
  *most = std::min(*most, m.x + m.y + m.z - *most);
  return m;
}

/// The whole link as its one solid, where that fits.
bool fits(const Link& link, Vec3& moments) {
  if (link.solids.size() != 1) return false;
  const Solid& solid = link.solids[0];
  if (length(solid.X_LS.p - link.p_LC) > kNearMiddle) return false;
  const Mat3 m = turned_tensor(conjugate(solid.X_LS.q), link.moments);
  moments = {m.x.x, m.y.y, m.z.z};
  const double most = std::max({moments.x, moments.y, moments.z});
  return std::max({std::abs(m.x.y), std::abs(m.y.z), std::abs(m.z.x)}) <= kNearAxes * most;
}

bool inside(const Solid& solid, const Vec3& p_L) {
  const Vec3 p = inverse(solid.X_LS) * p_L;
  const Vec3 half = solid.size * 0.5;
  if (solid.shape == ShapeType::sphere) return length(p) <= half.x;
  if (solid.shape == ShapeType::cylinder) {
    return std::hypot(p.x, p.y) <= half.x && std::abs(p.z) <= half.z;
  }
  return std::abs(p.x) <= half.x && std::abs(p.y) <= half.y && std::abs(p.z) <= half.z;
}

void say_of_kernel(const Link& link, const Reading& reading) {
  if (link.solids.empty()) {
    reading.left_out(link.place,
                     fmt::format("the link {} has nothing that touches: it is a cube of "
                                 "2 mm in its middle of mass",
                                 in_quotes(link.name)));
  } else if (std::none_of(link.solids.begin(), link.solids.end(),
                          [&](const Solid& one) { return inside(one, link.p_LC); })) {
    reading.left_out(
        link.place, fmt::format("the middle of mass of {} is outside of its shapes: a cube of 2 mm "
                                "stands there, which touches too",
                                in_quotes(link.name)));
  }
}

}  // namespace

Principal principal_moments(const Mat3& tensor) {
  Rows a = rows_of(tensor), v = rows_of(Mat3{});
  for (int sweep = 0; sweep < 30; ++sweep) {
    rotate_away(a, v, 0, 1);
    rotate_away(a, v, 0, 2);
    rotate_away(a, v, 1, 2);
  }
  Mat3 axes{{v[0][0], v[1][0], v[2][0]}, {v[0][1], v[1][1], v[2][1]}, {v[0][2], v[1][2], v[2][2]}};
  if (dot(cross(axes.x, axes.y), axes.z) < 0) axes.z = -axes.z;
  return {{a[0][0], a[1][1], a[2][2]}, quaternion_of(axes)};
}

Mat3 turned_tensor(const Quat& q, const Mat3& tensor) {
  const Mat3 r = matrix(q);
  const auto column = [&](const Vec3& e) { return r * (tensor * r.transposed(e)); };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

std::vector<Piece> pieces_of(const Link& link, const Reading& reading) {
  Vec3 moments;
  if (fits(link, moments)) {
    return {{link.name, link.solids[0], link.mass, possible(moments), link.solids[0].X_LS, false}};
  }
  say_of_kernel(link, reading);
  Piece kernel{link.name, {}, link.mass, {}, {link.p_LC, {}}, true};
  kernel.solid.size = Vec3{1, 1, 1} * kKernelSide;
  kernel.solid.place = link.place;
  Mat3 left = link.moments;
  Vec3 first_moment = link.p_LC * link.mass;
  std::vector<Piece> shells;
  for (std::size_t i = 0; i < link.solids.size(); ++i) {
    const Solid& solid = link.solids[i];
    const double mass = link.mass * kShellShare;
    const Vec3 own = moments_of(solid_body(solid, mass));
    // Of those that are too light for robot files the least is taken.
    const Vec3 m = possible(own);
    left = sum(left, rotated_diagonal(matrix(solid.X_LS.q), m), -1);
    left = sum(left, point_moments(mass, solid.X_LS.p - link.p_LC), -1);
    kernel.mass -= mass;
    first_moment = first_moment - solid.X_LS.p * mass;
    shells.push_back(
        {fmt::format("{} shape {}", link.name, i + 1), solid, mass, m, solid.X_LS, false});
  }
  kernel.X_LB.p = first_moment * (1 / kernel.mass);
  left = sum(left, point_moments(kernel.mass, kernel.X_LB.p - link.p_LC), -1);
  const Principal principal = principal_moments(left);
  kernel.moments = possible(principal.moments);
  kernel.X_LB.q = principal.q;
  shells.insert(shells.begin(), kernel);
  return shells;
}

}  // namespace stig::urdf
