// SPDX-License-Identifier: MIT
// The hull by brute force: O(n^4) in the number of points, for bodies of at most some dozen
// corners that are read once. It needs no careful ordering of cases, and coplanar triangles
// become one face without further work. Tolerances are relative to the largest distance
// between points.
#include "base/hull.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace stig {

namespace {

class Hull {
 public:
  explicit Hull(const std::vector<Vec3>& points) : points_(points) {
    for (const Vec3& p : points) {
      for (const Vec3& q : points) size_ = std::max(size_, length(p - q));
    }
    slack_ = 1e-9 * size_;
  }

  std::vector<HullFace> faces() {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        for (std::size_t k = j + 1; k < n; ++k) {
          const Vec3 across = cross(points_[j] - points_[i], points_[k] - points_[i]);
          // Three points in a line define no plane. Written so that NaN is rejected as
          // well.
          if (!(length(across) > slack_ * size_)) continue;
          const Vec3 normal = normalised(across);
          try_plane(points_[i], normal);
          try_plane(points_[i], -normal);
        }
      }
    }
    // A plane with all points in it is none of a solid.
    return faces_.size() < 4 ? std::vector<HullFace>{} : std::move(faces_);
  }

 private:
  // A plane belongs to the hull if no point lies above it; points on it are its corners.
  void try_plane(const Vec3& on, const Vec3& normal) {
    HullFace face{{}, normal};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double above = dot(points_[i] - on, normal);
      if (above > slack_) return;
      if (above > -slack_) face.corners.push_back(i);
    }
    // A plane is found by each of its triples; the first one counts.
    for (const HullFace& known : faces_) {
      if (dot(known.normal, normal) > 1 - 1e-9) return;
    }
    face.corners = go_round(face);
    faces_.push_back(std::move(face));
  }

  /// The outline of the points of a plane, from an extreme one on: each time the point that
  /// all others are to the left of. Gift wrapping (R. Jarvis 1973) within the
  /// plane; of points in a line the farthest is taken, so that none is left in the middle
  /// of an edge.
  std::vector<std::size_t> go_round(const HullFace& face) const {
    const auto& all = face.corners;
    assert(!all.empty());
    std::vector<std::size_t> out;
    std::size_t at = *std::max_element(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
      const Vec3 d = points_[a] - points_[b];
      const Vec3 u = perpendicular(face.normal);
      const double x = dot(d, u), y = dot(d, cross(face.normal, u));
      return std::abs(x) > slack_ ? x < 0 : y < 0;
    });
    do {
      out.push_back(at);
      std::size_t next = at;
      for (const std::size_t other : all) {
        const Vec3 step = points_[other] - points_[at];
        if (length(step) <= slack_) continue;
        const Vec3 best = points_[next] - points_[at];
        const double turn = dot(cross(best, step), face.normal);
        const bool farther = std::abs(turn) <= slack_ * size_ && squared(step) > squared(best);
        if (next == at || turn < -slack_ * size_ || farther) next = other;
      }
      at = next;
    } while (length(points_[at] - points_[out.front()]) > slack_ && out.size() < all.size());
    return out;
  }

  const std::vector<Vec3>& points_;
  double size_ = 0, slack_ = 0;
  std::vector<HullFace> faces_;
};

}  // namespace

std::vector<HullFace> hull_faces(const std::vector<Vec3>& points) { return Hull(points).faces(); }

namespace {

Vec3 products(const Vec3& a) { return {a.y * a.z, a.z * a.x, a.x * a.y}; }

}  // namespace

/// Integrals over tetrahedra are exact for polynomials of degree two. They are taken about
/// the first point to keep numbers small, and then moved to the centre of mass by the
/// parallel-axis theorem.
HullMass hull_mass(const std::vector<Vec3>& points) {
  // Tetrahedra from the first point; a tetrahedron's integral of x² is its volume over 20 times
  // the sum of its corners' squares and the square of their sum.
  HullMass out;
  Vec3 first, second, mixed;
  assert(!points.empty());
  const Vec3 origin = points[0];
  for (const HullFace& face : hull_faces(points)) {
    for (std::size_t i = 2; i < face.corners.size(); ++i) {
      const Vec3 a = points[face.corners[0]] - origin, b = points[face.corners[i - 1]] - origin,
                 c = points[face.corners[i]] - origin;
      const double volume = dot(a, cross(b, c)) / 6;
      const Vec3 sum = a + b + c;
      out.volume += volume;
      first += sum * (volume / 4);
      second += (scaled(a, a) + scaled(b, b) + scaled(c, c) + scaled(sum, sum)) * (volume / 20);
      mixed += (products(a) + products(b) + products(c) + products(sum)) * (volume / 20);
    }
  }
  if (out.volume <= 0) return {};
  const Vec3 centre = first * (1 / out.volume);
  out.centre = origin + centre;
  out.squares = second - scaled(centre, centre) * out.volume;
  out.products = mixed - products(centre) * out.volume;
  return out;
}

namespace {

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

PrincipalFrame principal_frame(const Vec3& squares, const Vec3& products) {
  Square m = symmetric(squares, products), axes = symmetric({1, 1, 1}, {});
  // Three by three: a handful of sweeps converges to the last bit, twelve are plenty.
  for (int sweep = 0; sweep < 12; ++sweep) {
    rotate_away(m, axes, 0, 1);
    rotate_away(m, axes, 0, 2);
    rotate_away(m, axes, 1, 2);
  }
  const auto column = [&axes](std::size_t i) { return Vec3{axes[0][i], axes[1][i], axes[2][i]}; };
  // The third axis by the cross product, so that the frame is right-handed.
  const Vec3 x = normalised(column(0)), y = normalised(column(1));
  return {quaternion_of({x, y, cross(x, y)}), {m[0][0], m[1][1], m[2][2]}};
}

}  // namespace stig
