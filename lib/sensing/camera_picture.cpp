// SPDX-License-Identifier: MIT
// Pixels are squares about whole numbers, as in camera_view.h, so a point's own pixel is the
// nearest whole number. Boxes about corners are wider than the corners' pixels, because a lens that
// bends straight edges can bulge them outwards between corners.
#include "sensing/camera_picture.h"

#include <algorithm>
#include <cmath>

namespace stig::sensing {

CameraPicture::CameraPicture(const CameraIntrinsics& camera, const Vec3& ground)
    : width(camera.width),
      height(camera.height),
      pixels(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height),
             ground) {}

PixelBox box_about(const CameraPicture& picture, const std::vector<ImagePoint>& points) {
  // Empty to begin with: the lower corner lies beyond the upper one, and stays there without
  // points.
  PixelBox b{picture.width, picture.height, -1, -1};
  for (const ImagePoint& p : points) {
    b.x0 = std::min(b.x0, static_cast<int>(std::floor(p.x)) - 2);
    b.y0 = std::min(b.y0, static_cast<int>(std::floor(p.y)) - 2);
    b.x1 = std::max(b.x1, static_cast<int>(std::ceil(p.x)) + 2);
    b.y1 = std::max(b.y1, static_cast<int>(std::ceil(p.y)) + 2);
  }
  return {std::max(b.x0, 0), std::max(b.y0, 0), std::min(b.x1, picture.width - 1),
          std::min(b.y1, picture.height - 1)};
}

PlaneHit meet_plane(const Pose& X_CT, const Vec3& way) {
  const Mat3 r = matrix(X_CT.q);
  // Points of the plane are those with r.z · (p - X_CT.p) = 0; t is measured in lengths of `way`,
  // so that it is the depth where way.z is 1.
  const double along = dot(r.z, way);
  if (along == 0) return {};
  const double t = dot(r.z, X_CT.p) / along;
  const Vec3 p = r.transposed(way * t - X_CT.p);
  return {p.x, p.y, t};
}

}  // namespace stig::sensing
