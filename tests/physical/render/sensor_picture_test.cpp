// SPDX-License-Identifier: MIT
// What a camera sees, as a picture.
#include "physical/render/sensor_picture.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "physical/sensors/sensor_support.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// A body 20 cm ahead of the camera, turned about the image's vertical.
CameraPicture picture_of(const SightShape& shape, double turn = 0) {
  SensorScene scene;
  scene.floor = false;
  // Its z along the image's y.
  hide_behind(scene, shape, {{0, 0, 0.2}, rotation({0, turn, 0}) * rotation({90 * kDegree, 0, 0})});
  return camera_picture(scene, paper_view().intrinsics, {}, 1);
}

/// How bright it is so far to the right of the middle, in m at the body's distance.
double brightness(const CameraPicture& picture, double right) {
  return picture.grey(static_cast<int>(319.5 + 883.961 * right / 0.2), 180);
}

}  // namespace

TEST_CASE("a cylinder darkens towards its sides, a box does not") {
  const CameraPicture round = picture_of(sight_cylinder(0.02, 0.05));
  CHECK(brightness(round, 0.01) < brightness(round, 0) - 5);
  CHECK(brightness(round, 0.017) < brightness(round, 0.01) - 5);
  CHECK(brightness(round, -0.01) == doctest::Approx(brightness(round, 0.01)).epsilon(0.01));
  const CameraPicture flat = picture_of(sight_box({0.04, 0.04, 0.05}));
  CHECK(brightness(flat, 0.017) == doctest::Approx(brightness(flat, 0)).epsilon(0.01));
}

TEST_CASE("a hull is shaded by the face that is seen") {
  // A roof of 45 degrees whose ridge is upright in the image and towards the camera.
  const Shape roof = Shape::hull({{0, -0.02, 0.02},
                                  {0, -0.02, -0.02},
                                  {0.02, 0, 0.02},
                                  {0.02, 0, -0.02},
                                  {-0.02, 0, 0.02},
                                  {-0.02, 0, -0.02}});
  const CameraPicture even = picture_of(sight_of(roof));
  CHECK(brightness(even, 0.005) == doctest::Approx(brightness(even, -0.005)).epsilon(0.02));
  CHECK(brightness(even, 0.005) == doctest::Approx(brightness(even, 0.015)).epsilon(0.1));
  // The ridge goes to one side: the middle belongs to the face that is turned to the camera.
  const CameraPicture turned = picture_of(sight_of(roof), 30 * kDegree);
  const double middle = brightness(turned, 0);
  const double left = brightness(turned, -0.0135), right = brightness(turned, 0.0135);
  CHECK(std::max(left, right) == doctest::Approx(middle).epsilon(0.05));
  CHECK(std::min(left, right) < middle - 20);
}
