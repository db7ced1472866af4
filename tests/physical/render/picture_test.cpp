// SPDX-License-Identifier: MIT
#include "physical/render/raster.h"
#include "physical/render/scene_picture.h"
#include "physical/render/solid_faces.h"
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr Rgb kRed{200, 0, 0}, kBlue{0, 0, 200}, kWhite{255, 255, 255};

std::size_t count(const Image& image, Rgb colour) {
  return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

PictureBody drawn_block(const Vec3& p) {
  PictureBody body;
  body.shape = Shape::box({0.055, 0.055, 0.055});
  body.X_WB.p = p;
  body.block = true;
  return body;
}

}  // namespace

TEST_CASE("a triangle covers the pixels inside, either way round") {
  const RasterPoint a{-0.5, -0.5, 1}, b{9.5, -0.5, 1}, c{-0.5, 9.5, 1};
  for (const bool turned : {false, true}) {
    Raster raster(10, 10, kWhite);
    if (turned) {
      raster.triangle(a, c, b, kRed);
    } else {
      raster.triangle(a, b, c, kRed);
    }
    CHECK(count(raster.image(), kRed) == 55);  // the diagonal too
    CHECK(raster.image().at(0, 0) == kRed);
    CHECK(raster.image().at(9, 9) == kWhite);
  }
}

TEST_CASE("the nearer covers the farther, in whatever order they come") {
  for (const bool first : {false, true}) {
    Raster raster(8, 8, kWhite);
    const auto near = [&] { raster.triangle({-9, -9, 2}, {30, -9, 2}, {-9, 30, 2}, kRed); };
    const auto far = [&] { raster.triangle({-9, -9, 1}, {30, -9, 1}, {-9, 30, 1}, kBlue); };
    first ? (near(), far()) : (far(), near());
    CHECK(count(raster.image(), kRed) == 64);
  }
}

TEST_CASE("two triangles that cross change places where they do") {
  Raster raster(100, 1, kWhite);
  // Of depth 1 throughout, and from 2 m on the left to 0.5 m on the right.
  raster.triangle({0, -5, 1}, {99, -5, 1}, {49.5, 50, 1}, kRed);
  raster.triangle({0, -5, 0.5}, {99, -5, 2}, {49.5, 50, 1.25}, kBlue);
  CHECK(raster.image().at(20, 0) == kRed);
  CHECK(raster.image().at(80, 0) == kBlue);
  CHECK(raster.image().at(28, 0) == kRed);
  CHECK(raster.image().at(38, 0) == kBlue);
}

TEST_CASE("shadows darken once, and only what is not nearer") {
  Raster raster(4, 4, kWhite);
  raster.shade({-9, -9, 1}, {30, -9, 1}, {-9, 30, 1}, 0.5);
  raster.shade({-9, -9, 1}, {30, -9, 1}, {-9, 30, 1}, 0.5);
  CHECK(raster.image().at(1, 1) == Rgb{128, 128, 128});
  Raster covered(4, 4, kWhite);
  covered.triangle({-9, -9, 2}, {30, -9, 2}, {-9, 30, 2}, kRed);
  covered.shade({-9, -9, 1}, {30, -9, 1}, {-9, 30, 1}, 0.5);
  CHECK(count(covered.image(), kRed) == 16);
}

TEST_CASE("corners that are no numbers, or far outside, draw nothing and do no harm") {
  Raster raster(4, 4, kWhite);
  raster.triangle({0, 0, 1}, {std::nan(""), 0, 1}, {0, 4, 1}, kRed);
  raster.triangle({1e300, 0, 1}, {-1e300, 1, 1}, {0, 1e300, 1}, kRed);
  raster.line({1, 1, 1}, {1, 1, 1}, 3, kRed, 0);
  CHECK(count(raster.image(), kRed) == 0);
}

TEST_CASE("samples are averaged") {
  Raster raster(2, 2, {0, 0, 0});
  raster.triangle({-0.4, -0.4, 1}, {0.4, -0.4, 1}, {0, 0.4, 1}, {200, 100, 40});
  const Image image = raster.image(2);
  REQUIRE(image.pixels.size() == 1);
  CHECK(image.pixels[0] == Rgb{50, 25, 10});
}

TEST_CASE("faces look outwards and close the shape") {
  for (const Shape& shape : {Shape::box({0.1, 0.2, 0.3}), Shape::sphere(0.1)}) {
    Vec3 sum;  // of the faces' areas as vectors: nothing, for a closed surface
    for (const SolidFace& face : faces_of(shape)) {
      CHECK(dot(face.normal, face.corners[0]) > 0);
      Vec3 area;
      for (std::size_t i = 2; i < face.corners.size(); ++i) {
        area += cross(face.corners[i - 1] - face.corners[0], face.corners[i] - face.corners[0]);
      }
      CHECK(dot(area, face.normal) > 0);
      sum += area;
    }
    CHECK(length(sum) < 1e-12);
  }
}

TEST_CASE("a fitted view holds every body, from any side") {
  std::vector<PictureBody> bodies;
  for (int i = 0; i < 12; ++i)
    bodies.push_back(drawn_block({0.1 * i, 0.05 * (i % 3), 0.03 + 0.06 * (i % 4)}));
  for (const double azimuth : {-3.0, -1.05, 0.0, 0.7, 1.6, 3.1}) {
    for (const double elevation : {0.1, 0.42, 1.2}) {
      PictureLook look;
      look.azimuth = azimuth;
      look.elevation = elevation;
      const PictureView view = fitted_view(bodies, look);
      const Mat3 r = matrix(view.X_WC.q);
      for (const PictureBody& body : bodies) {
        const auto pixel = project(view.camera, r.transposed(body.X_WB.p - view.X_WC.p));
        REQUIRE(pixel);
        CHECK(pixel->x > 0);
        CHECK(pixel->x < look.width);
        CHECK(pixel->y > 0);
        CHECK(pixel->y < look.height);
      }
      // Level: up is up.
      CHECK(std::abs(r.x.z) < 1e-12);
      CHECK(r.y.z < 0);
    }
  }
}

TEST_CASE("a picture shows its bodies, what has rolled away aside, and is the same every time") {
  std::vector<PictureBody> bodies = {drawn_block({0, 0, 0.0275}), drawn_block({0.1, 0, 0.0275})};
  bodies[0].led = Led::q3;
  PictureLook look;
  look.width = 300;
  look.height = 200;
  const ScenePicture one = draw_bodies(bodies, fitted_view(bodies, look), true);
  CHECK(one.image.width == 300);
  CHECK(one.grid > 0);
  const auto green = std::count_if(one.image.pixels.begin(), one.image.pixels.end(),
                                   [](Rgb p) { return p.g > p.r + 40 && p.g > p.b + 40; });
  CHECK(green > 500);
  CHECK(png_of(one.image, "test") ==
        png_of(draw_bodies(bodies, fitted_view(bodies, look), true).image, "test"));
  const double distance = length(fitted_view(bodies, look).X_WC.p);
  for (int i = 0; i < 20; ++i) bodies.push_back(drawn_block({0.06 * i, 0.2, 0.0275}));
  bodies.push_back(drawn_block({50, 0, 0.0275}));
  CHECK(length(fitted_view(bodies, look).X_WC.p) < 20 * distance);
  CHECK(png_of(draw_bodies({}, fitted_view({}, look), true).image, "").starts_with("\x89PNG"));
}
