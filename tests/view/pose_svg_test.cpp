// SPDX-License-Identifier: MIT
#include "view/pose_svg.h"

#include <doctest/doctest.h>

#include "support/uses.h"

namespace stig {
namespace {

PictureBody cube_at(const Vec3& p, Rgb colour) {
  PictureBody body;
  body.shape = Shape::box({0.055, 0.055, 0.055});
  body.X_WB.p = p;
  body.colour = colour;
  return body;
}

TEST_CASE("a drawing of bodies, its caption and its floor: the same bytes whatever comes first") {
  const std::vector<PictureBody> bodies = {cube_at({0, -0.2, 0.0275}, {200, 0, 0}),
                                           cube_at({0, 0.2, 0.0275}, {0, 0, 200})};
  PictureLook look;
  look.azimuth = -1.5;
  const PictureView view = fitted_view(bodies, look);
  const auto floor = floor_under(points_about(bodies));
  const std::string svg = pose_svg(bodies, view, floor, {}, "two cubes");
  CHECK(svg.find("<svg") != std::string::npos);
  CHECK(svg == pose_svg(bodies, view, floor, {}, "two cubes"));
  CHECK(svg != pose_svg(bodies, view, floor, {}, ""));
  CHECK(svg != pose_svg(bodies, view, std::nullopt, {}, "two cubes"));
  // The order is that of distances, not the one in which they are given.
  CHECK(svg == pose_svg({bodies[1], bodies[0]}, view, floor, {}, "two cubes"));
}

}  // namespace
}  // namespace stig
