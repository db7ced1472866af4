// SPDX-License-Identifier: MIT
// Pictures as a camera takes them, slowly: each pixel is the mean of lines of sight through
// it. For tests that read pictures back with others' programs.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec.h"
#include "sensing/camera.h"

namespace stig {

/// Red, green and blue, 0 to 255, row by row.
struct CameraPicture {
  int width = 0, height = 0;
  std::vector<Vec3> pixels;

  CameraPicture(const CameraIntrinsics& camera, const Vec3& ground)
      : width(camera.width),
        height(camera.height),
        pixels(std::size_t(camera.width) * std::size_t(camera.height), ground) {}
  Vec3& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  double grey(int x, int y) const {
    const Vec3& p = pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    return 0.299 * p.x + 0.587 * p.y + 0.114 * p.z;
  }
};

struct PixelBox {
  int x0, y0, x1, y1;  ///< inclusive
};
inline PixelBox whole(const CameraPicture& p) { return {0, 0, p.width - 1, p.height - 1}; }
/// About these points, a little wider, within the picture.
inline PixelBox box_about(const CameraPicture& p, const std::vector<ImagePoint>& points) {
  PixelBox b{p.width, p.height, -1, -1};
  for (const ImagePoint& i : points) {
    b.x0 = std::min(b.x0, int(std::floor(i.x)) - 2), b.x1 = std::max(b.x1, int(std::ceil(i.x)) + 2);
    b.y0 = std::min(b.y0, int(std::floor(i.y)) - 2), b.y1 = std::max(b.y1, int(std::ceil(i.y)) + 2);
  }
  return {std::max(b.x0, 0), std::max(b.y0, 0), std::min(b.x1, p.width - 1),
          std::min(b.y1, p.height - 1)};
}

/// `shade(way, ground)` is the colour seen along a direction (z = 1), `ground` what the picture
/// had there; `samples` squared lines a pixel.
template <class Shade>
void paint(CameraPicture& picture, const CameraIntrinsics& camera, const PixelBox& box, int samples,
           const Shade& shade) {
  for (int y = box.y0; y <= box.y1; ++y) {
    for (int x = box.x0; x <= box.x1; ++x) {
      Vec3 sum;
      for (int i = 0; i < samples * samples; ++i) {
        const double u = x - 0.5 + (i % samples + 0.5) / samples;
        const double v = y - 0.5 + (i / samples + 0.5) / samples;
        const auto way = unproject(camera, {u, v});
        sum += way ? shade(*way, picture.at(x, y)) : picture.at(x, y);
      }
      picture.at(x, y) = sum * (1.0 / (samples * samples));
    }
  }
}

/// Where a line of sight meets the plane z = 0 of a frame, and how far ahead (z of the camera);
/// not ahead: a depth below 0.
struct PlaneHit {
  double x = 0, y = 0, depth = -1;
};
inline PlaneHit meet_plane(const Pose& X_CT, const Vec3& way) {
  const Mat3 r = matrix(X_CT.q);
  const double along = dot(r.z, way);
  if (along == 0) return {};
  const double t = dot(r.z, X_CT.p) / along;
  const Vec3 p = r.transposed(way * t - X_CT.p);
  return {p.x, p.y, t};
}

}  // namespace stig
