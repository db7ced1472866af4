// SPDX-License-Identifier: MIT
// Vectors, rotations and poses, just enough for rigid bodies: plain doubles, evaluated in
// the order written, so that results are the same on every machine.
#pragma once

#include <cmath>

namespace stig {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  constexpr Vec3 operator-() const { return {-x, -y, -z}; }
  constexpr Vec3& operator+=(const Vec3& o) { return *this = {x + o.x, y + o.y, z + o.z}; }
  constexpr Vec3& operator-=(const Vec3& o) { return *this = {x - o.x, y - o.y, z - o.z}; }
  constexpr Vec3& operator*=(double s) { return *this = {x * s, y * s, z * s}; }
};
constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
constexpr Vec3 operator*(Vec3 a, double s) { return a *= s; }
constexpr Vec3 operator*(double s, Vec3 a) { return a *= s; }

constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr Vec3 scaled(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr double squared(const Vec3& a) { return dot(a, a); }
inline double length(const Vec3& a) { return std::sqrt(squared(a)); }
inline Vec3 normalised(const Vec3& a) { return a * (1 / length(a)); }
inline bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
/// Some unit vector at a right angle to a unit vector.
inline Vec3 perpendicular(const Vec3& a) {
  return normalised(std::abs(a.z) < 0.8 ? Vec3{-a.y, a.x, 0} : Vec3{0, -a.z, a.y});
}

/// Three columns; of a rotation: the axes of the turned frame.
struct Mat3 {
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  constexpr Vec3 operator*(const Vec3& v) const { return x * v.x + y * v.y + z * v.z; }
  /// The transpose times v; of a rotation: its inverse.
  constexpr Vec3 transposed(const Vec3& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
  const Vec3& column(int i) const { return i == 0 ? x : i == 1 ? y : z; }
};
/// R diag(d) R^T.
constexpr Mat3 rotated_diagonal(const Mat3& r, const Vec3& d) {
  const auto column = [&](const Vec3& e) { return r * scaled(d, r.transposed(e)); };
  return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

/// A unit quaternion w + xi + yj + zk.
struct Quat {
  double w = 1, x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Quat&, const Quat&) = default;
};
constexpr Quat operator*(const Quat& a, const Quat& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quat normalised(const Quat& q) {
  const double s = 1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}
/// The turn by |v| radians about v; exact, also for tiny angles.
inline Quat rotation(const Vec3& v) {
  const double angle = length(v);
  const double s = angle < 1e-8 ? 0.5 : std::sin(angle / 2) / angle;
  return {std::cos(angle / 2), v.x * s, v.y * s, v.z * s};
}
constexpr Mat3 matrix(const Quat& q) {
  return {
      {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)},
      {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)},
      {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}};
}

/// The quaternion of a rotation, from its largest component (Shepperd 1978).
inline Quat quaternion_of(const Mat3& r) {
  const double trace = r.x.x + r.y.y + r.z.z;
  Quat q;
  if (trace > 0) {
    q = {1 + trace, r.y.z - r.z.y, r.z.x - r.x.z, r.x.y - r.y.x};
  } else if (r.x.x >= r.y.y && r.x.x >= r.z.z) {
    q = {r.y.z - r.z.y, 1 + r.x.x - r.y.y - r.z.z, r.x.y + r.y.x, r.z.x + r.x.z};
  } else if (r.y.y >= r.z.z) {
    q = {r.z.x - r.x.z, r.x.y + r.y.x, 1 + r.y.y - r.x.x - r.z.z, r.y.z + r.z.y};
  } else {
    q = {r.x.y - r.y.x, r.z.x + r.x.z, r.y.z + r.z.y, 1 + r.z.z - r.x.x - r.y.y};
  }
  return normalised(q);
}

constexpr Quat conjugate(const Quat& q) { return {q.w, -q.x, -q.y, -q.z}; }
constexpr Vec3 rotate(const Quat& q, const Vec3& v) { return matrix(q) * v; }
/// The smallest angle of the turn, 0 to pi radians.
inline double angle_of(const Quat& q) {
  return 2 * std::atan2(length(Vec3{q.x, q.y, q.z}), std::abs(q.w));
}

/// Where a frame stands in another: first turned by q, then moved by p. X_AC = X_AB * X_BC,
/// p_A = X_AB * p_B.
struct Pose {
  Vec3 p;
  Quat q;

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};
constexpr Pose operator*(const Pose& a, const Pose& b) {
  return {a.p + rotate(a.q, b.p), a.q * b.q};
}
constexpr Vec3 operator*(const Pose& x, const Vec3& p) { return x.p + rotate(x.q, p); }
constexpr Pose inverse(const Pose& x) { return {-rotate(conjugate(x.q), x.p), conjugate(x.q)}; }

}  // namespace stig
