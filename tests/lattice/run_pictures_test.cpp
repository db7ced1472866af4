// SPDX-License-Identifier: MIT
// All pictures of a run have one frame.
#include "lattice/run_pictures.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "png_image.h"
#include "support/any_structure.h"
#include "support/golden.h"
#include "support/uses.h"

namespace stig {
namespace {

RunPictureOptions small() {
  RunPictureOptions options;
  options.width = 300;
  options.height = 200;
  options.azimuth = -0.9;
  options.elevation = 0.5;
  options.floor = true;
  options.legend = false;
  return options;
}

const Rgb kRedTop = blend({0xc8, 0, 0}, {255, 255, 255}, 0.16);  // of red bricks

std::vector<Brick> red_and_blue() {
  std::vector<Brick> made = numbered_bricks(2);
  made[0].color = "#c80000";
  made[1].color = "#0000c8";
  return made;
}

// A pixel that the red brick covers wholly, be it by a side or an edge: these are darker than its
// top, whereas ground that shines through at a border is far greener.
bool on_red_brick(Rgb pixel) {
  return pixel.r >= pixel.b && pixel.g <= kRedTop.g && pixel.b <= kRedTop.b;
}

// A pixel of the red top that a blue brick may have touched. A trace of an edge, less than a tenth
// of a pixel, is too little to tell by its blue; a little ground shines through between faces.
bool blue_upon_red_top(Rgb pixel) {
  const bool hardly = kRedTop.r - pixel.r <= 20;
  return pixel.r < kRedTop.r && pixel.g < 100 && (hardly || pixel.b > pixel.g + 4);
}

// Neither picture has all that is red in the other: a neighbour covers tops, and it hides sides
// whose edges, with round ends, darken a few pixels of the top. Anything else is a brick that
// moved.
bool stays_in_place(const PngImage& alone, const PngImage& more) {
  for (std::size_t i = 0; i < more.pixels.size(); ++i) {
    const Rgb before = alone.pixels[i], now = more.pixels[i];
    if (now == kRedTop && !on_red_brick(before)) return false;
    if (before == kRedTop && now != kRedTop && !blue_upon_red_top(now)) return false;
  }
  return true;
}

TEST_CASE("law: every picture of a run has the size of all, and its bricks stay in place") {
  CHECK(rc::check([] {
    const Lattice lattice = any_lattice();
    std::vector<PlacedBrick> bricks = any_structure(lattice, 4, 2).bricks();
    RC_PRE(!bricks.empty());
    for (PlacedBrick& brick : bricks) brick.brick = 2;
    bricks.front().brick = 1;
    RunPictureOptions options = small();
    options.azimuth = *rc::gen::inRange(0, 6283) / 1000.0;
    const RunPictures pictures(Structure(lattice, bricks), red_and_blue(), options);
    const auto count = *rc::gen::inRange<std::size_t>(1, bricks.size() + 1);
    bricks.resize(count);
    const PngImage alone = png_image(pictures.draw(Structure(lattice, {bricks.front()}), ""));
    const PngImage more = png_image(pictures.draw(Structure(lattice, bricks), ""));
    RC_ASSERT(alone.width == 300 && alone.height == 200);
    RC_ASSERT(more.width == 300 && more.height == 200);
    RC_ASSERT(stays_in_place(alone, more));
  }));
}

TEST_CASE("what stays in place is told from what moves by a pixel") {
  const Structure red = structure_literal("1");
  const RunPictures pictures(structure_literal("1 2"), red_and_blue(), small());
  const PngImage alone = png_image(pictures.draw(red, ""));
  CHECK(stays_in_place(alone, png_image(pictures.draw(structure_literal("1 2"), ""))));
  for (const int by : {1, -1, alone.width, -alone.width}) {
    PngImage moved = alone;
    const auto middle = by > 0 ? moved.pixels.end() - by : moved.pixels.begin() - by;
    std::rotate(moved.pixels.begin(), middle, moved.pixels.end());
    CAPTURE(by);
    CHECK_FALSE(stays_in_place(alone, moved));
  }
}

TEST_CASE("going round, the middle stays and nothing leaves the page") {
  Structure tower;
  for (int z = 0; z < 4; ++z) tower.place({5, -3, z}, 1);
  tower.place({9, -3, 0}, 2);
  RunPictureOptions options = small();
  options.orbit = true;
  const RunPictures pictures(tower, red_and_blue(), options);
  for (int i = 0; i < 24; ++i) {
    const PngImage page = png_image(pictures.draw(tower, "", 2 * std::numbers::pi * i / 24));
    CAPTURE(i);
    CHECK(page.width == 300);
    bool clean = true;
    for (int x = 0; x < page.width; ++x) {
      for (const int y : {0, 1, 198, 199}) clean = clean && page.at(x, y) == Rgb{255, 255, 255};
    }
    for (int y = 0; y < page.height; ++y) {
      for (const int x : {0, 1, 298, 299}) clean = clean && page.at(x, y) == Rgb{255, 255, 255};
    }
    CHECK(clean);
  }
}

TEST_CASE("a ghost lets through what is behind it") {
  const Structure whole = structure_literal("1 2");
  RunPictureOptions options = small();
  options.floor = false;
  const RunPictures plain(whole, red_and_blue(), options);
  options.ghost = true;
  const RunPictures ghosts(whole, red_and_blue(), options);
  const Structure now = structure_literal("1");
  CHECK(plain.draw(now, "") != ghosts.draw(now, ""));
  CHECK(plain.draw(whole, "") == ghosts.draw(whole, ""));
}

TEST_CASE("pictures without bricks, in every form, the same bytes twice") {
  for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
    for (const bool orbit : {false, true}) {
      RunPictureOptions options = small();
      options.format = format;
      options.orbit = orbit;
      options.legend = true;
      options.title = "Nothing yet";
      const RunPictures pictures(Structure{}, {}, options);
      const std::string bytes = pictures.draw(Structure{}, "0 bricks");
      CHECK(bytes.size() > 500);
      CHECK(bytes == RunPictures(Structure{}, {}, options).draw(Structure{}, "0 bricks"));
    }
  }
}

TEST_CASE("the palettes are those of the viewer, in its order") {
  const std::string viewer = project_file("tools/viewer/src/colours.ts");
  for (const auto& [name, palette, count] :
       {std::tuple("kOkabeIto", Palette::okabe_ito, 8), {"kTolBright", Palette::tol_bright, 7}}) {
    std::size_t at = viewer.find(std::string("const ") + name);
    REQUIRE(at != std::string::npos);
    const std::size_t end = viewer.find(']', at);
    for (int k = 1; k <= count; ++k) {
      at = viewer.find("'#", at);
      REQUIRE(at < end);
      CHECK(viewer.substr(++at, 7) == to_color(rgb_in(palette, static_cast<Colour>(k))));
    }
    CHECK(viewer.find("'#", at) > end);
    CHECK(rgb_in(palette, static_cast<Colour>(count + 1)) == rgb_in(palette, 1));
  }
  const auto bricks = recoloured(red_and_blue(), Palette::tol_bright, 4);
  CHECK(bricks.size() == 4);
  CHECK(bricks[1].color == "#ee6677");
  CHECK(bricks[3].symbol == "4");
}

}  // namespace
}  // namespace stig
