// SPDX-License-Identifier: MIT
// What lies inside a camera's image and reach: its frustum, with borders bent by distortion.
//
// Image borders: pixels are squares about whole numbers, as in OpenCV, so an image of
// `width` covers -0.5 <= u <= width - 0.5. Near and far are planes across the optical axis;
// all borders count as inside.
#pragma once

#include <array>
#include <optional>

#include "sensing/camera.h"

namespace stig::sensing {

/// Made by make_view.
struct CameraView {
  CameraIntrinsics intrinsics;
  double near = 0, far = 0;  ///< m, along the optical axis
  Vec3 low, high;            ///< about all directions (z = 1) that the image shows
  bool distorted = false;
};

/// Nothing when the camera makes no sense: f, the image or near..far are empty or not finite,
/// or the distortion has no inverse on the image's border.
std::optional<CameraView> make_view(const CameraIntrinsics& intrinsics, double near, double far);

bool inside_image(const CameraIntrinsics& camera, const ImagePoint& pixel);

/// Where a point in the camera's frame is seen; nothing when it is outside the frustum, also
/// when the distortion's formula folds it back into the image from far outside.
std::optional<ImagePoint> image_of(const CameraView& view, const Vec3& p_C);

/// A pyramid's stump about all that image_of shows, camera frame: near plane, far plane.
std::array<Vec3, 8> frustum_corners(const CameraView& view);

}  // namespace stig::sensing
