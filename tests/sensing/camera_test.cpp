// SPDX-License-Identifier: MIT
#include "sensing/camera.h"

#include <doctest/doctest.h>

#include "support.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// The formulas of OpenCV's documentation of calib3d, term by term.
ImagePoint written_formula(const CameraIntrinsics& c, const Pose& X_CW, const Vec3& p_W) {
  using Real = long double;
  const Vec3 p = X_CW * p_W;
  const Real x = Real(p.x) / p.z, y = Real(p.y) / p.z;
  const Real r2 = x * x + y * y, r4 = r2 * r2, r6 = r4 * r2;
  const Real radial =
      (1 + c.k1 * r2 + c.k2 * r4 + c.k3 * r6) / (1 + c.k4 * r2 + c.k5 * r4 + c.k6 * r6);
  const auto& s = c.thin_prism;
  const Real xd = x * radial + 2 * c.p1 * x * y + c.p2 * (r2 + 2 * x * x) + s[0] * r2 + s[1] * r4;
  const Real yd = y * radial + c.p1 * (r2 + 2 * y * y) + 2 * c.p2 * x * y + s[2] * r2 + s[3] * r4;
  return {double(c.fx * xd + c.cx), double(c.fy * yd + c.cy)};
}

double distance(const ImagePoint& a, const ImagePoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

TEST_CASE("projection is OpenCV's, over random poses and distortions") {
  CHECK(rc::check("equal to 1e-9 px", [] {
    const CameraIntrinsics camera = some_camera();
    const Pose X_CW{{0.3 * unit_value(), 0.3 * unit_value(), value_in(0.8, 2)},
                    rotation({unit_value() * 3, unit_value() * 3, unit_value() * 3})};
    const Vec3 p_W{0.3 * unit_value(), 0.3 * unit_value(), 0.3 * unit_value()};
    const auto pixel = project(camera, X_CW * p_W);
    RC_ASSERT(pixel.has_value());
    RC_ASSERT(distance(*pixel, written_formula(camera, X_CW, p_W)) < 1e-9);
  }));
}

TEST_CASE("unproject is the inverse all over the image") {
  CHECK(rc::check("project after unproject", [] {
    const CameraIntrinsics camera = some_camera();
    const ImagePoint pixel{value_in(-0.5, 639.5), value_in(-0.5, 359.5)};
    const auto way = unproject(camera, pixel);
    RC_ASSERT(way.has_value());
    RC_ASSERT(distance(*project(camera, *way), pixel) < 1e-9);
  }));
  CHECK(rc::check("unproject after project", [] {
    const CameraIntrinsics camera = some_camera();
    const Vec3 way{value_in(-0.3, 0.3), value_in(-0.2, 0.2), 1};
    const auto back = unproject(camera, *project(camera, way));
    RC_ASSERT(back.has_value());
    RC_ASSERT(length(*back - way) * camera.fx < 1e-9);
  }));
}

TEST_CASE("the slope is the derivative of the projection") {
  CHECK(rc::check("central differences", [] {
    const CameraIntrinsics camera = some_camera();
    const double x = 0.3 * unit_value(), y = 0.3 * unit_value(), h = 1e-5;
    const ImageSlope slope = image_slope(camera, {2 * x, 2 * y, 2});
    const auto at = [&](double dx, double dy) { return *project(camera, {x + dx, y + dy, 1}); };
    const ImagePoint left = at(-h, 0), right = at(h, 0), up = at(0, -h), down = at(0, h);
    RC_ASSERT(std::abs((right.x - left.x) / (2 * h) - slope.ux) < 1e-5);
    RC_ASSERT(std::abs((right.y - left.y) / (2 * h) - slope.vx) < 1e-5);
    RC_ASSERT(std::abs((down.x - up.x) / (2 * h) - slope.uy) < 1e-5);
    RC_ASSERT(std::abs((down.y - up.y) / (2 * h) - slope.vy) < 1e-5);
  }));
}

TEST_CASE("nothing in or behind the lens is seen, and nothing comes from where nothing goes") {
  const CameraIntrinsics camera = paper_camera();
  CHECK(!project(camera, {0, 0, 0}));
  CHECK(!project(camera, {0.1, 0, -1}));
  CHECK(!project(camera, {NAN, 0, NAN}));
  CameraIntrinsics barrel = camera;
  barrel.k1 = -0.5;  // x' - x'^3/2 is never above 0.545
  CHECK(unproject(barrel, {barrel.cx + 0.5 * barrel.fx, barrel.cy}));
  CHECK(!unproject(barrel, {barrel.cx + 0.56 * barrel.fx, barrel.cy}));
}
