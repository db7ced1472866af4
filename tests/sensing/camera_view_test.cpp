// SPDX-License-Identifier: MIT
#include "sensing/camera_view.h"

#include <doctest/doctest.h>

#include "support.h"
#include "support/uses.h"

using namespace stig;

namespace {

CameraView view_of(const CameraIntrinsics& camera) {
  const auto view = make_view(camera, 0.05, 0.5);
  REQUIRE(view);
  return *view;
}

/// The point that a pixel shows at this depth.
Vec3 point_at(const CameraIntrinsics& camera, double u, double v, double depth) {
  const auto way = unproject(camera, {u, v});
  REQUIRE(way);
  return *way * depth;
}

CameraIntrinsics bent_camera() {
  CameraIntrinsics c = paper_camera();
  c.k1 = -0.25;
  c.k2 = 0.1;
  c.p1 = 0.003;
  c.p2 = -0.002;
  return c;
}

}  // namespace

TEST_CASE("each border of the frustum: just inside and just outside") {
  for (const CameraIntrinsics& camera : {paper_camera(), bent_camera()}) {
    const CameraView view = view_of(camera);
    const auto seen = [&](double u, double v, double depth) {
      return image_of(view, point_at(camera, u, v, depth)).has_value();
    };
    for (const double along : {0.0, 100.0, 359.0}) {
      CHECK(seen(-0.499, along, 0.2));
      CHECK(!seen(-0.501, along, 0.2));
      CHECK(seen(639.499, along, 0.2));
      CHECK(!seen(639.501, along, 0.2));
      CHECK(seen(along, -0.499, 0.2));
      CHECK(!seen(along, -0.501, 0.2));
      CHECK(seen(along, 359.499, 0.2));
      CHECK(!seen(along, 359.501, 0.2));
    }
    CHECK(seen(320, 180, 0.05));
    CHECK(!seen(320, 180, 0.0499));
    CHECK(seen(320, 180, 0.5));
    CHECK(!seen(320, 180, 0.5001));
  }
}

TEST_CASE("what distortion folds back into the image is not seen") {
  CameraIntrinsics barrel = paper_camera();
  barrel.k1 = -0.5;
  const CameraView view = view_of(barrel);
  // x' - x'^3/2 is 0.1 at 0.1010 and again near 1.36.
  const Vec3 folded{1.3603 * 0.2, 0, 0.2};
  const auto pixel = project(barrel, folded);
  REQUIRE(pixel);
  CHECK(inside_image(barrel, *pixel));
  CHECK(!image_of(view, folded));
}

TEST_CASE("the stump holds all that is seen") {
  CHECK(rc::check("every pixel", [] {
    const CameraIntrinsics camera = some_camera();
    const auto view = make_view(camera, 0.05, 0.5);
    RC_PRE(view.has_value());
    const double u = value_in(-0.5, 639.5), v = value_in(-0.5, 359.5);
    const ImagePoint pixel = *rc::gen::element(ImagePoint{u, v}, ImagePoint{u, -0.5},
                                               ImagePoint{639.5, v}, ImagePoint{-0.5, v});
    const auto way = unproject(camera, pixel);
    RC_ASSERT(way.has_value());
    RC_ASSERT(image_of(*view, *way * 0.3).has_value());
    RC_ASSERT((way->x >= view->low.x && way->x <= view->high.x));
    RC_ASSERT((way->y >= view->low.y && way->y <= view->high.y));
  }));
  const CameraView view = view_of(paper_camera());
  const auto corners = frustum_corners(view);
  CHECK(corners[0].x == doctest::Approx(-320 / 883.961 * 0.05));
  CHECK(corners[6].x == doctest::Approx(320 / 883.961 * 0.5));
  CHECK(corners[6].y == doctest::Approx(180 / 883.961 * 0.5));
  CHECK(corners[6].z == doctest::Approx(0.5));
}

TEST_CASE("cameras that make no sense have no view") {
  const auto refused = [](auto change, double near = 0.05, double far = 0.5) {
    CameraIntrinsics c = paper_camera();
    change(c);
    return !make_view(c, near, far);
  };
  const auto nothing = [](CameraIntrinsics&) {};
  CHECK(!refused(nothing));
  CHECK(refused(nothing, 0, 0.5));
  CHECK(refused(nothing, 0.5, 0.5));
  CHECK(refused(nothing, 0.05, INFINITY));
  CHECK(refused([](CameraIntrinsics& c) { c.fx = 0; }));
  CHECK(refused([](CameraIntrinsics& c) { c.fy = NAN; }));
  CHECK(refused([](CameraIntrinsics& c) { c.width = 0; }));
  CHECK(refused([](CameraIntrinsics& c) { c.k1 = NAN; }));
  CHECK(refused([](CameraIntrinsics& c) { c.k1 = -5; }));  // no inverse at the corners
}
