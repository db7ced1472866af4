// SPDX-License-Identifier: MIT
#include "lattice/picture.h"

#include <doctest/doctest.h>

#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "png_image.h"
#include "support/uses.h"

namespace stig {
namespace {

PictureOptions bare() {
  PictureOptions options;
  options.axes = options.legend = false;
  return options;
}

const std::vector<Brick>& bricks() {
  static const std::vector<Brick> list = [] {
    std::vector<Brick> made = numbered_bricks(2);
    made[0].color = "#c80000";
    made[1].color = "#0000c8";
    return made;
  }();
  return list;
}

constexpr Rgb kTop{0xd1, 0x29, 0x29}, kLeft{0xb8, 0, 0}, kRight{0x90, 0, 0};

TEST_CASE("a brick shows a light top, a left and a dark right side") {
  const PngImage image = png_image(draw_structure(structure_literal("1"), bricks(), bare()));
  const auto top = image.find(kTop), left = image.find(kLeft), right = image.find(kRight);
  CHECK(top.count > 1000);
  CHECK(left.count > 1000);
  CHECK(right.count > 1000);
  CHECK(top.y < left.y);
  CHECK(top.y < right.y);
  CHECK(left.x < right.x);
  CHECK(image.pixels[0] == Rgb{255, 255, 255});
}

TEST_CASE("a brick in front covers the one behind") {
  Structure s;
  s.place({0, 0, 0}, 1);
  s.place({3, -4, 4}, 2);  // on the line of sight, nearly
  const PngImage image = png_image(draw_structure(s, bricks(), bare()));
  const PngImage behind = png_image(draw_structure(structure_literal("1"), bricks(), bare()));
  CHECK(image.find(Rgb{0, 0, 0xb8}).count > 1000);
  CHECK(image.find(kTop).count < behind.find(kTop).count / 2);
}

TEST_CASE("the same input gives the same bytes") {
  PictureOptions options;
  options.title = "Title";
  options.caption = "Caption";
  options.floor = true;
  const Structure s = structure_literal("1 .\n---\n1 2");
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
    options.format = format;
    const std::string bytes = draw_structure(s, bricks(), options);
    CHECK_FALSE(bytes.empty());
    CHECK(bytes == draw_structure(s, bricks(), options));
  }
}

TEST_CASE("pictures stay within their size") {
  Structure s;
  for (int i = 0; i < 3000; ++i) s.place({i, 0, 0}, 1);
  PictureOptions options;
  options.title = std::string(300, 'W');
  options.floor = true;
  const PngImage image = png_image(draw_structure(s, bricks(), options));
  CHECK(image.width <= options.most_pixels);
  CHECK(image.height <= options.most_pixels);
  CHECK(image.find(kTop).count + image.find(kLeft).count > 0);
}

TEST_CASE("loose bricks by the thousand: the covered ones are not missed") {
  Structure s;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 60; ++y) {
      for (int z = 0; z < 20; ++z) {
        if ((x * 7 + y * 3 + z * 5) % 4 != 0) s.place({x, y, z}, 1);
      }
    }
  }
  const PngImage image = png_image(draw_structure(s, bricks(), bare()));
  int inside = 0, white = 0;
  for (int y = image.height * 2 / 5; y < image.height * 3 / 5; ++y) {
    for (int x = image.width * 2 / 5; x < image.width * 3 / 5; ++x, ++inside) {
      white += image.pixels[static_cast<std::size_t>(y * image.width + x)].g > 150;
    }
  }
  CHECK(inside > 10000);
  CHECK(white == 0);
}

TEST_CASE("several structures are drawn side by side on one scale") {
  const Structure one = structure_literal("1"), two = structure_literal("2 2");
  const PngImage image =
      png_image(draw_structures({{&one, "first"}, {&two, "second"}}, bricks(), bare()));
  const auto red = image.find(kLeft), blue = image.find(Rgb{0, 0, 0xb8});
  CHECK(red.x < blue.x);
  CHECK(blue.count > 1.7 * red.count);
}

TEST_CASE("empty structures, hexagonal ones and odd views can be drawn") {
  PictureOptions options;
  options.floor = true;
  CHECK(png_image(draw_structure(Structure(), {}, options)).width > 0);
  options.turns = 5;
  const Structure prism = structure_literal("1 2\n2 1", Lattice::hexagonal);
  CHECK(png_image(draw_structure(prism, bricks(), options)).find(kTop).count > 1000);
}

TEST_CASE("an .svg of too many faces is refused") {
  Structure s;
  for (int x = 0; x < 300; ++x) {
    for (int y = 0; y < 300; ++y) s.place({2 * x, 2 * y, 0}, 1);
  }
  PictureOptions options = bare();
  options.format = PictureFormat::svg;
  CHECK(draw_structure(s, bricks(), options).empty());
}

}  // namespace
}  // namespace stig
