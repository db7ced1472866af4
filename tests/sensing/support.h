// SPDX-License-Identifier: MIT
// Random cameras and views, shared by the tests of sensing.
#pragma once

#include <rapidcheck.h>

#include <cmath>

#include "base/degree.h"
#include "sensing/tag_pose.h"
#include "support/uses.h"

namespace stig {

/// A multiple of 1/10000 from -1 to 1.
inline double unit_value() { return *rc::gen::inRange(-10000, 10001) * 1e-4; }
inline double value_in(double low, double high) {
  return low + (high - low) * (unit_value() + 1) / 2;
}

/// The robot's camera as published: no distortion.
inline CameraIntrinsics paper_camera() {
  CameraIntrinsics c;
  c.fx = c.fy = 883.961;
  c.cx = 319.5;
  c.cy = 179.5;
  return c;
}

/// Distortion of webcams, up to tens of pixels at the image's border, of every term.
inline CameraIntrinsics some_camera() {
  CameraIntrinsics c;
  c.fx = value_in(600, 1000);
  c.fy = c.fx * value_in(0.95, 1.05);
  c.cx = 319.5 + 20 * unit_value();
  c.cy = 179.5 + 20 * unit_value();
  c.k1 = 0.2 * unit_value();
  c.k2 = 0.05 * unit_value();
  c.k3 = 0.02 * unit_value();
  c.p1 = 0.005 * unit_value();
  c.p2 = 0.005 * unit_value();
  c.k4 = 0.05 * unit_value();
  c.k5 = 0.02 * unit_value();
  c.k6 = 0.01 * unit_value();
  for (double& s : c.thin_prism) s = 0.004 * unit_value();
  return c;
}

/// A tag before the camera at this distance, turned `tilt` from facing it about some axis of its
/// plane, after a turn about its normal.
inline Pose tag_before(const Vec3& p_C, double tilt, double tilt_axis, double spin) {
  const Quat facing{0, 1, 0, 0};  // z towards the camera, x right, y up
  const Quat about = rotation(Vec3{std::cos(tilt_axis), std::sin(tilt_axis), 0} * tilt);
  return {p_C, facing * about * rotation({0, 0, spin})};
}

inline std::array<ImagePoint, 4> corners_of(const CameraIntrinsics& camera, const Pose& X_CT,
                                            double side) {
  std::array<ImagePoint, 4> out;
  const auto places = tag_corners(side);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto pixel = project(camera, X_CT * places[i]);
    RC_PRE(pixel.has_value());
    out[i] = *pixel;
  }
  return out;
}

inline double turn_between(const Pose& a, const Pose& b) { return angle_of(conjugate(a.q) * b.q); }

}  // namespace stig
