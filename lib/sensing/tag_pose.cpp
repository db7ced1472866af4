// SPDX-License-Identifier: MIT
// In short: pixels → directions on the plane z = 1 (distortion taken out) → the homography's
// first-order part at the tag's centre → two rotations that share it (IPPE, Collins and Bartoli
// 2014) → the place that fits each best, a linear problem → both refined by Levenberg-Marquardt on
// the error in pixels → the better of the two. Everything is in closed form but the refinement,
// which converges in a handful of rounds.
#include "sensing/tag_pose.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::sensing {

namespace {

constexpr int kMostFitRounds = 40;
constexpr double kNoError = 1e-18;   ///< px², summed: nothing to gain below
constexpr double kNoGain = 1e-10;    ///< of the error: refinement has ended
constexpr double kFlattest = 1e-3;   ///< of a corner's triangle: twice its area by longest edge²
constexpr double kWorstFit = 1e150;  ///< px²: no pose at all

/// A corner as the refinement knows it.
struct Corner {
  Vec3 p_T;
  double x = 0, y = 0;  ///< observed, without distortion, on the plane z = 1
  ImageSlope slope;     ///< there: turns errors into pixels, to first order
};
using Corners = std::array<Corner, 4>;

/// The image of the tag's centre on the plane z = 1, and how it moves with the place on
/// the tag, by metre.
struct CentreMap {
  double x = 0, y = 0;
  double xx = 0, xy = 0, yx = 0, yy = 0;  ///< dx/dX, dx/dY, dy/dX, dy/dY
};

// Twice the signed area of the triangle, positive when it turns from x to y.
double turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

/// Convex and counter-clockwise as seen; y points down here.
bool is_proper(const Corners& c) {
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &a = c[i], &b = c[(i + 1) % 4];
    longest = std::max(longest, (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    // A relative bound: a tag far away is small in pixels but no worse for it.
    if (!(-turn(c[i], c[(i + 1) % 4], c[(i + 2) % 4]) > kFlattest * longest)) return false;
  }
  return true;
}

/// From the homography of the unit square, in closed form (Heckbert 1989, "Fundamentals of
/// texture mapping and image warping").
CentreMap centre_map(const Corners& c, double side) {
  // The names are Heckbert's: g and h are the projective terms, which vanish when the tag is seen
  // frontally; x and y at (1/2, 1/2) of the unit square is where its centre appears.
  const double ax = c[1].x - c[2].x, ay = c[1].y - c[2].y;
  const double bx = c[3].x - c[2].x, by = c[3].y - c[2].y;
  const double sx = c[0].x - c[1].x + c[2].x - c[3].x, sy = c[0].y - c[1].y + c[2].y - c[3].y;
  const double det = ax * by - bx * ay;
  const double g = (sx * by - bx * sy) / det, h = (ax * sy - sx * ay) / det;
  const double xu = c[1].x - c[0].x + g * c[1].x, xv = c[3].x - c[0].x + h * c[3].x;
  const double yu = c[1].y - c[0].y + g * c[1].y, yv = c[3].y - c[0].y + h * c[3].y;
  const double w = 1 + (g + h) / 2;
  const double x = (c[0].x + (xu + xv) / 2) / w, y = (c[0].y + (yu + yv) / 2) / w;
  const double by_metre = 1 / (w * side);
  return {x,
          y,
          (xu - g * x) * by_metre,
          (xv - h * x) * by_metre,
          (yu - g * y) * by_metre,
          (yv - h * y) * by_metre};
}

/// The rotation that brings the z axis to a unit vector, by the shortest way; v.z > -1.
Mat3 turned_to(const Vec3& v) {
  // Rodrigues' formula with the angle's sine and cosine replaced by the vector's components; a tag
  // in view is before the camera, so v.z is never near -1.
  const double s = 1 / (1 + v.z);
  return {{1 - v.x * v.x * s, -v.x * v.y * s, -v.x}, {-v.x * v.y * s, 1 - v.y * v.y * s, -v.y}, v};
}

/// Both rotations that have the map's derivative at the centre.
std::array<Mat3, 2> rotations_of(const CentreMap& m) {
  // With the line of sight to the centre as z axis the projection is, to first order, the same in
  // all directions, and what is left of the derivative is an orthographic view: the upper left 2 ×
  // 2 block of the rotation, times the inverse of the distance.
  const Mat3 to_centre = turned_to(normalised(Vec3{m.x, m.y, 1}));
  const Vec3 &r0 = to_centre.x, &r1 = to_centre.y;
  // Image of the turned frame's x and y axes, inverted and put before the derivative.
  const double b00 = r0.x - m.x * r0.z, b01 = r1.x - m.x * r1.z;
  const double b10 = r0.y - m.y * r0.z, b11 = r1.y - m.y * r1.z;
  const double det = b00 * b11 - b01 * b10;
  double a00 = (b11 * m.xx - b01 * m.yx) / det, a01 = (b11 * m.xy - b01 * m.yy) / det;
  double a10 = (b00 * m.yx - b10 * m.xx) / det, a11 = (b00 * m.yy - b10 * m.xy) / det;
  // The larger singular value is 1 by the distance.
  const double sum = a00 * a00 + a01 * a01 + a10 * a10 + a11 * a11;
  const double area = a00 * a11 - a01 * a10;
  const double s = 1 / std::sqrt((sum + std::sqrt(std::max(0.0, sum * sum - 4 * area * area))) / 2);
  a00 *= s, a01 *= s, a10 *= s, a11 *= s;
  // Columns of a rotation are unit vectors, so their z components follow but for one common sign:
  // that sign is the ambiguity. The two are negatives or not so that the columns are orthogonal.
  const double c0 = std::sqrt(std::max(0.0, 1 - a00 * a00 - a10 * a10));
  const double c1 =
      std::copysign(std::sqrt(std::max(0.0, 1 - a01 * a01 - a11 * a11)), -(a00 * a01 + a10 * a11));
  std::array<Mat3, 2> out;
  for (const int sign : {1, -1}) {
    const Vec3 x{a00, a10, sign * c0}, y{a01, a11, sign * c1};
    out[sign == 1 ? 0 : 1] = {to_centre * x, to_centre * y, to_centre * cross(x, y)};
  }
  return out;
}

/// Least squares of x (r.z + t.z) = r.x + t.x and its like in y, which are linear in t.
Vec3 place_of(const Corners& corners, const Mat3& r) {
  double mx = 0, my = 0, ma = 0, mb = 0;
  std::array<std::array<double, 4>, 4> rows;  // x, y, and what t must make up for
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner& c = corners[i];
    const Vec3 p = r * c.p_T;
    rows[i] = {c.x, c.y, c.x * p.z - p.x, c.y * p.z - p.y};
    mx += c.x / 4, my += c.y / 4, ma += rows[i][2] / 4, mb += rows[i][3] / 4;
  }
  double above = 0, below = 0;
  // With the tag's own terms moved out of the way, only the depth couples the two coordinates: a
  // straight line fitted through four corners in each, of one slope.
  for (const auto& [x, y, a, b] : rows) {
    above -= (x - mx) * (a - ma) + (y - my) * (b - mb);
    below += (x - mx) * (x - mx) + (y - my) * (y - my);
  }
  const double z = above / below;
  return {ma + mx * z, mb + my * z, z};
}

struct Row6 {
  std::array<double, 6> d{};  ///< by a turn and a move of the tag, camera frame
  double error = 0;           ///< px
};

/// The two rows of a corner, or false when it is not before the camera.
bool rows_of(const Corner& c, const Pose& X_CT, Row6& u, Row6& v) {
  const Vec3 arm = rotate(X_CT.q, c.p_T);
  const Vec3 p = X_CT.p + arm;
  if (!(p.z > 0)) return false;
  const double x = p.x / p.z, y = p.y / p.z, iz = 1 / p.z;
  const double ex = x - c.x, ey = y - c.y;
  // d(x, y) by the point, then the point by a turn w: w × arm.
  const Vec3 gx{iz, 0, -x * iz}, gy{0, iz, -y * iz};
  const ImageSlope& s = c.slope;
  const Vec3 gu = gx * s.ux + gy * s.uy, gv = gx * s.vx + gy * s.vy;
  const Vec3 tu = cross(arm, gu), tv = cross(arm, gv);
  u = {{tu.x, tu.y, tu.z, gu.x, gu.y, gu.z}, s.ux * ex + s.uy * ey};
  v = {{tv.x, tv.y, tv.z, gv.x, gv.y, gv.z}, s.vx * ex + s.vy * ey};
  return true;
}

struct Normal {
  std::array<std::array<double, 6>, 6> m{};  ///< lower triangle
  std::array<double, 6> g{};
  double cost = 0;

  void add(const Row6& r) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j) m[i][j] += r.d[i] * r.d[j];
      g[i] += r.d[i] * r.error;
    }
    cost += r.error * r.error;
  }
};

Normal normal_at(const Corners& corners, const Pose& X_CT) {
  Normal n;
  Row6 u, v;
  for (const Corner& c : corners) {
    if (!rows_of(c, X_CT, u, v)) {
      n.cost = kWorstFit;
      return n;
    }
    n.add(u);
    n.add(v);
  }
  return n;
}

/// Solves (M + damping · diag M) d = -g by Cholesky's method; false when it is singular. The
/// damping scales the diagonal (Marquardt), so that turns in rad and moves in m need no common
/// unit.
bool solve(Normal n, double damping, std::array<double, 6>& d) {
  auto& m = n.m;
  for (std::size_t i = 0; i < 6; ++i) m[i][i] *= 1 + damping;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double s = m[i][j];
      for (std::size_t k = 0; k < j; ++k) s -= m[i][k] * m[j][k];
      if (j < i) {
        m[i][j] = s / m[j][j];
      } else if (s > 0) {
        m[i][i] = std::sqrt(s);
      } else {
        return false;
      }
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    double s = -n.g[i];
    for (std::size_t k = 0; k < i; ++k) s -= m[i][k] * d[k];
    d[i] = s / m[i][i];
  }
  for (std::size_t i = 6; i-- > 0;) {
    for (std::size_t k = i + 1; k < 6; ++k) d[i] -= m[k][i] * d[k];
    d[i] /= m[i][i];
  }
  return true;
}

struct Fit {
  Pose X_CT;
  double cost = kWorstFit;
};

Fit refine(const Corners& corners, const Pose& start) {
  Fit fit{start, 0};
  Normal n = normal_at(corners, start);
  double damping = 1e-6;
  // Steps that make it worse raise the damping until the step is tiny; 1e9 means that no step
  // helps, which is the minimum as far as doubles can tell.
  for (int round = 0; round < kMostFitRounds && n.cost > kNoError && damping < 1e9; ++round) {
    std::array<double, 6> d{};
    if (!solve(n, damping, d)) {
      damping = damping * 10;
      continue;
    }
    const Pose tried{fit.X_CT.p + Vec3{d[3], d[4], d[5]},
                     normalised(rotation({d[0], d[1], d[2]}) * fit.X_CT.q)};
    const Normal at = normal_at(corners, tried);
    if (!(at.cost < n.cost)) {
      damping *= 10;
      continue;
    }
    // Gains shrink quadratically here, so one that is tiny is the last that matters.
    const bool settled = n.cost - at.cost < kNoGain * n.cost;
    fit.X_CT = tried;
    n = at;
    damping *= 0.1;
    if (settled) break;
  }
  fit.cost = n.cost;
  return fit;
}

bool prepare(const CameraIntrinsics& camera, const std::array<ImagePoint, 4>& pixels, double side,
             Corners& corners) {
  const auto places = tag_corners(side);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto way = unproject(camera, pixels[i]);
    if (!way) return false;
    corners[i] = {places[i], way->x, way->y, image_slope(camera, *way)};
  }
  return is_proper(corners);
}

}  // namespace

std::array<Vec3, 4> tag_corners(double side) {
  assert(side >= 0);
  const double h = side / 2;
  return {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}};
}

std::optional<TagPose> estimate_tag_pose(const CameraIntrinsics& camera,
                                         const std::array<ImagePoint, 4>& corners, double side) {
  Corners prepared;
  if (!(side > 0) || !prepare(camera, corners, side, prepared)) return std::nullopt;
  const CentreMap map = centre_map(prepared, side);
  std::array<Fit, 2> fits;
  const auto rotations = rotations_of(map);
  for (std::size_t i = 0; i < 2; ++i) {
    // Both are refined, not the first alone: near frontal views the cruder estimate of the two may
    // be the right one.
    fits[i] = refine(prepared, {place_of(prepared, rotations[i]), quaternion_of(rotations[i])});
  }
  if (fits[1].cost < fits[0].cost) std::swap(fits[0], fits[1]);
  const auto centre = project(camera, {map.x, map.y, 1});
  // kWorstFit: a corner came to lie behind the camera, so that no pose fits at all.
  if (!centre || !(fits[0].cost < kWorstFit)) return std::nullopt;
  return TagPose{fits[0].X_CT, std::sqrt(fits[0].cost / 4), fits[1].X_CT,
                 std::sqrt(fits[1].cost / 4), *centre};
}

}  // namespace stig::sensing
