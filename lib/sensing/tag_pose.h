// SPDX-License-Identifier: MIT
// Where a square tag stands, from the pixels of its four corners alone.
//
// The corners' homography has two rotations that fit to first order (Collins and Bartoli
// 2014, "Infinitesimal plane-based pose estimation"): tilted this way or, nearly, mirrored.
// Both are refined until the sum of squared pixel errors is least (Levenberg and Marquardt's
// method), and the better one is the answer. Far away or seen frontally the two fit noisy pixels
// almost equally well and the wrong one may win, with real cameras as here.
//
// Frame of a tag T: origin in its centre, x right and y up as seen by who looks at it upright,
// z out of its face towards the viewer.
#pragma once

#include <array>
#include <optional>

#include "sensing/camera.h"

namespace stig::sensing {

/// A tag's corners, tag frame: lower left, lower right, upper right, upper left.
std::array<Vec3, 4> tag_corners(double side);

struct TagPose {
  Pose X_CT;
  double error = 0;  ///< px, root mean square of the corners' distances
  /// The other solution; the same as the first where the two are one.
  Pose X_CT_other;
  double other_error = 0;
  ImagePoint centre;  ///< where the corners say that the tag's centre appears
};

/// Corners in the order of tag_corners; `side` in m. Distortion is taken out first. Nothing when
/// they are no convex quadrilateral, run the wrong way round (a tag seen from behind), lie
/// almost in a line, or where the distortion has no inverse.
std::optional<TagPose> estimate_tag_pose(const CameraIntrinsics& camera,
                                         const std::array<ImagePoint, 4>& corners, double side);

}  // namespace stig::sensing
