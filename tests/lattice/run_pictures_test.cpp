// SPDX-License-Identifier: MIT
// All pictures of a run have one frame.
#include "lattice/run_pictures.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

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
    // What is red with others about it is red without them.
    const auto before = alone.where(kRedTop), now = more.where(kRedTop);
    for (std::size_t i = 0; i < now.size(); ++i) RC_ASSERT(!now[i] || before[i]);
  }));
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
