// SPDX-License-Identifier: MIT
// Forth, the model of OpenCV's calib3d is a formula; back, it has no closed form and is inverted by
// Newton's method with the formula's own derivatives. The derivatives are also what turns errors on
// the image plane into errors in pixels for tag_pose.cpp, so they are worked out once, here.
#include "sensing/camera.h"

#include <cassert>
#include <cmath>

namespace stig::sensing {

namespace {

// Newton's method doubles the digits each round; the bound is for calibrations that make no sense.
constexpr int kMostRounds = 60;
constexpr double kExact = 1e-13;  ///< of the normalised image plane

/// Distorted coordinates of a point of the plane z = 1, and their derivatives.
struct Distorted {
  double x, y;
  double xx, xy, yx, yy;  ///< dx''/dx', dx''/dy', dy''/dx', dy''/dy'
};

Distorted distort(const CameraIntrinsics& c, double x, double y) {
  // The names follow the comment of camera.h: radial = above / below, a rational function of r².
  // Slopes are by r², and the chain rule below brings in d(r²)/dx = 2x.
  const double r2 = x * x + y * y;
  const double above = 1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  const double below = 1 + r2 * (c.k4 + r2 * (c.k5 + r2 * c.k6));
  const double radial = above / below;
  const double above_slope = c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3);  // by r²
  const double below_slope = c.k4 + r2 * (2 * c.k5 + r2 * 3 * c.k6);
  const double slope = (above_slope - radial * below_slope) / below;
  const auto& s = c.thin_prism;
  const double prism_x = s[0] + 2 * s[1] * r2, prism_y = s[2] + 2 * s[3] * r2;  // by r²
  return {x * radial + 2 * c.p1 * x * y + c.p2 * (r2 + 2 * x * x) + r2 * (s[0] + s[1] * r2),
          y * radial + c.p1 * (r2 + 2 * y * y) + 2 * c.p2 * x * y + r2 * (s[2] + s[3] * r2),
          radial + 2 * x * x * slope + 2 * c.p1 * y + 6 * c.p2 * x + 2 * x * prism_x,
          2 * x * y * slope + 2 * c.p1 * x + 2 * c.p2 * y + 2 * y * prism_x,
          2 * x * y * slope + 2 * c.p1 * x + 2 * c.p2 * y + 2 * x * prism_y,
          radial + 2 * y * y * slope + 6 * c.p1 * y + 2 * c.p2 * x + 2 * y * prism_y};
}

}  // namespace

std::optional<ImagePoint> project(const CameraIntrinsics& camera, const Vec3& p_C) {
  // Written so that NaN fails too.
  if (!(p_C.z > 0)) return std::nullopt;
  const Distorted d = distort(camera, p_C.x / p_C.z, p_C.y / p_C.z);
  return ImagePoint{camera.fx * d.x + camera.cx, camera.fy * d.y + camera.cy};
}

ImageSlope image_slope(const CameraIntrinsics& camera, const Vec3& direction) {
  assert(direction.z > 0);
  const Distorted d = distort(camera, direction.x / direction.z, direction.y / direction.z);
  return {camera.fx * d.xx, camera.fx * d.xy, camera.fy * d.yx, camera.fy * d.yy};
}

std::optional<Vec3> unproject(const CameraIntrinsics& camera, const ImagePoint& pixel) {
  const double to_x = (pixel.x - camera.cx) / camera.fx, to_y = (pixel.y - camera.cy) / camera.fy;
  double x = to_x, y = to_y;
  // Newton's method; without distortion the first round ends it.
  for (int round = 0; round < kMostRounds; ++round) {
    const Distorted d = distort(camera, x, y);
    const double ex = to_x - d.x, ey = to_y - d.y;
    const double det = d.xx * d.yy - d.xy * d.yx;
    if (std::abs(ex) < kExact && std::abs(ey) < kExact) {
      // Beyond a fold of the formula lie more solutions, which no lens shows.
      if (!(det > 0 && d.xx + d.yy > 0)) return std::nullopt;
      return Vec3{x, y, 1};
    }
    // Where the Jacobian's determinant vanishes the image folds over: no direction there is
    // certain.
    if (!(std::abs(det) > 1e-12)) return std::nullopt;
    x += (ex * d.yy - ey * d.xy) / det;
    y += (ey * d.xx - ex * d.yx) / det;
    if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace stig::sensing
