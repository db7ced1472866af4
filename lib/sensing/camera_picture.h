// SPDX-License-Identifier: MIT
// Pictures as a camera takes them, slowly: each pixel is the mean of lines of sight through it,
// bent as the lens bends them. What a line of sight meets is for the caller to say.
#pragma once

#include <vector>

#include "base/vec.h"
#include "sensing/camera.h"

namespace stig::sensing {

/// Red, green and blue, 0 to 255, row by row.
struct CameraPicture {
  int width = 0, height = 0;
  std::vector<Vec3> pixels;

  CameraPicture(const CameraIntrinsics& camera, const Vec3& ground);
  Vec3& at(int x, int y) { return pixels[place(x, y)]; }
  double grey(int x, int y) const {
    const Vec3& p = pixels[place(x, y)];
    return 0.299 * p.x + 0.587 * p.y + 0.114 * p.z;
  }

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

struct PixelBox {
  int x0 = 0, y0 = 0, x1 = -1, y1 = -1;  ///< inclusive
};
/// About these points, a little wider, within the picture.
PixelBox box_about(const CameraPicture& picture, const std::vector<ImagePoint>& points);

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
PlaneHit meet_plane(const Pose& X_CT, const Vec3& way);

}  // namespace stig::sensing
