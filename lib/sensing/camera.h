// SPDX-License-Identifier: MIT
// The camera: pinhole with OpenCV's distortion, forth and back.
//
// Camera frame C: z ahead, x right, y down. With x' = x/z, y' = y/z, r² = x'² + y'²:
//
//     radial = (1 + k1 r² + k2 r⁴ + k3 r⁶) / (1 + k4 r² + k5 r⁴ + k6 r⁶)
//     x'' = x' radial + 2 p1 x'y' + p2 (r² + 2x'²) + s1 r² + s2 r⁴
//     y'' = y' radial + p1 (r² + 2y'²) + 2 p2 x'y' + s3 r² + s4 r⁴
//     u = fx x'' + cx,  v = fy y'' + cy
//
// as OpenCV's documentation of calib3d has it, so that calibrations carry over.
#pragma once

#include <array>
#include <optional>

#include "base/vec.h"

namespace stig::sensing {

/// A point on the image plane, pixels: x right, y down, from the upper left corner.
struct ImagePoint {
  double x = 0, y = 0;
};

struct CameraIntrinsics {
  int width = 640, height = 360;  ///< pixels
  double fx = 0, fy = 0, cx = 0, cy = 0;
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;
  double k4 = 0, k5 = 0, k6 = 0;       ///< rational model
  std::array<double, 4> thin_prism{};  ///< s1 s2 s3 s4
};

/// Where a point in the camera's frame appears, inside the image or not; nothing when it lies
/// in or behind the plane of the lens.
std::optional<ImagePoint> project(const CameraIntrinsics& camera, const Vec3& p_C);
/// How the image moves with the direction (x, y, 1) that is looked along, pixels: du/dx, du/dy,
/// dv/dx, dv/dy.
struct ImageSlope {
  double ux = 0, uy = 0, vx = 0, vy = 0;
};
ImageSlope image_slope(const CameraIntrinsics& camera, const Vec3& direction);
/// The direction (z = 1) that a pixel looks along; nothing where the distortion has no inverse
/// that continues the one at the principal point.
std::optional<Vec3> unproject(const CameraIntrinsics& camera, const ImagePoint& pixel);

}  // namespace stig::sensing
