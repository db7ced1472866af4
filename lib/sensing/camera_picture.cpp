// SPDX-License-Identifier: MIT
#include "sensing/camera_picture.h"

#include <algorithm>
#include <cmath>

namespace stig {

CameraPicture::CameraPicture(const CameraIntrinsics& camera, const Vec3& ground)
    : width(camera.width),
      height(camera.height),
      pixels(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height),
             ground) {}

PixelBox box_about(const CameraPicture& picture, const std::vector<ImagePoint>& points) {
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
  const double along = dot(r.z, way);
  if (along == 0) return {};
  const double t = dot(r.z, X_CT.p) / along;
  const Vec3 p = r.transposed(way * t - X_CT.p);
  return {p.x, p.y, t};
}

}  // namespace stig
