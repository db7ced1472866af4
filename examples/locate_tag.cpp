// SPDX-License-Identifier: MIT
// Where does a tag stand, from the pixels of its corners? stig::sensing: the camera's projection,
// and its inverse for squares of known size.
#include <array>
#include <cmath>
#include <cstdio>

#include "sensing/camera.h"
#include "sensing/tag_pose.h"

int main() {
  // A calibration as OpenCV gives it: focal lengths and principal point in pixels, distortion.
  stig::sensing::CameraIntrinsics camera;
  camera.width = 640, camera.height = 360;
  camera.fx = camera.fy = 884, camera.cx = 320, camera.cy = 180;
  camera.k1 = -0.1;

  // A tag of 24 mm, 20 cm ahead and a little to the right, upright and turned towards the camera
  // but for 0.3 rad. Camera frame: z ahead, x right, y down; the tag's z points out of its face.
  constexpr double kSide = 0.024;
  const stig::Quat facing = stig::rotation({M_PI, 0, 0}) * stig::rotation({0, 0.3, 0});
  const stig::Pose X_CT{{0.03, -0.01, 0.2}, facing};

  // What a detector of tags would report: where the four corners appear.
  std::array<stig::sensing::ImagePoint, 4> corners;
  const auto places = stig::sensing::tag_corners(kSide);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = *stig::sensing::project(camera, X_CT * places[i]);
    std::printf("corner %zu at (%.1f, %.1f) px\n", i, corners[i].x, corners[i].y);
  }

  // A square in perspective has two poses that nearly fit; the better one is X_CT.
  const auto found = stig::sensing::estimate_tag_pose(camera, corners, kSide);
  if (!found) return 1;
  const stig::Vec3 p = found->X_CT.p;
  std::printf("tag at (%.4f, %.4f, %.4f) m, the other solution %.2f px off\n", p.x, p.y, p.z,
              found->other_error);
}
