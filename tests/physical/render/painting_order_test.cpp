// SPDX-License-Identifier: MIT
// Painted one upon the other in that order, bodies look as with the depth of each pixel.
#include "physical/render/painting_order.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>

#include "support/uses.h"

namespace stig {
namespace {

constexpr int kWide = 120, kHigh = 90;  // pixels

/// Polygons alone, each upon all before it, or the nearer upon the farther.
class Painted final : public PictureSink {
 public:
  explicit Painted(bool deep) : deep_(deep) {}
  void polygon(const std::vector<RasterPoint>& corners, Rgb colour) override {
    ++count_;
    const auto point = [&](std::size_t i) {
      RasterPoint out = corners[i];
      if (!deep_) out.inverse_depth = count_;
      return out;
    };
    for (std::size_t i = 2; i < corners.size(); ++i) {
      raster_.triangle(point(0), point(i - 1), point(i), colour);
    }
  }
  void shadow(const std::vector<RasterPoint>& /*corners*/, double /*darkness*/) override {}
  void line(const RasterPoint& /*from*/, const RasterPoint& /*to*/, double /*width*/,
            Rgb /*colour*/, double /*bias*/) override {}
  Image image() const { return raster_.image(); }

 private:
  bool deep_;
  double count_ = 0;
  Raster raster_{kWide, kHigh, {255, 255, 255}};
};

Image painted(const std::vector<PictureBody>& bodies, const PictureView& view, bool deep) {
  Painted out(deep);
  paint_bodies(out, bodies, view, std::nullopt, {});
  return out.image();
}

std::size_t differing(const Image& a, const Image& b) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) out += a.pixels[i] == b.pixels[i] ? 0 : 1;
  return out;
}

PictureBody body_at(const std::array<int, 3>& cell, Shape shape, Rgb colour) {
  PictureBody body;
  body.shape = std::move(shape);
  body.X_WB.p = {0.06 * cell[0], 0.06 * cell[1], 0.06 * cell[2]};
  body.colour = colour;
  return body;
}

TEST_CASE("law: bodies painted in their order look as with depth") {
  CHECK(rc::check([] {
    const auto cells = *rc::gen::container<std::set<std::array<int, 3>>>(
        rc::gen::container<std::array<int, 3>>(rc::gen::inRange(0, 4)));
    std::vector<PictureBody> bodies;
    for (const std::array<int, 3>& cell : cells) {
      const bool ball = *rc::gen::arbitrary<bool>();
      const auto part = [] { return static_cast<std::uint8_t>(*rc::gen::inRange(0, 256)); };
      bodies.push_back(body_at(
          cell,
          ball ? Shape::sphere(0.027) : Shape::box({0.06, 0.06, *rc::gen::element(0.03, 0.06)}),
          {part(), part(), part()}));
    }
    PictureLook look;
    look.width = kWide;
    look.height = kHigh;
    look.azimuth = *rc::gen::inRange(0, 6283) / 1000.0;
    look.elevation = *rc::gen::inRange(-1500, 1500) / 1000.0;
    const PictureView view = fitted_view(bodies, look);
    const Image deep = painted(bodies, view, true);
    const Image flat = painted(painting_order(bodies, view), view, false);
    // Pixels on the line where two faces meet may be either's.
    RC_ASSERT(differing(deep, flat) <= 60);
  }));
}

TEST_CASE("what stands before another is painted after it, however far its middle is") {
  // A long beam whose middle is nearer to the eye than the cube in front of its end.
  PictureBody beam = body_at({0, 0, 0}, Shape::box({0.06, 2, 0.06}), {200, 0, 0});
  PictureBody cube = body_at({1, 14, 0}, Shape::box({0.06, 0.06, 0.06}), {0, 0, 200});
  PictureView view = fitted_view({beam, cube}, {kWide, kHigh, 0, 0.2, false});
  const auto order = painting_order({cube, beam}, view);
  REQUIRE(order.size() == 2);
  CHECK(order[1].colour == cube.colour);
}

}  // namespace
}  // namespace stig
