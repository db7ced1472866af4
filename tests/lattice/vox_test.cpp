// SPDX-License-Identifier: MIT
#include "lattice/vox.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "base/bytes.h"
#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "lattice/vox_scene.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

std::string numbers(std::initializer_list<int> values) {
  std::string out;
  for (const int value : values) put(out, static_cast<std::int32_t>(value));
  return out;
}

std::string text(std::string_view value) {
  std::string out;
  put(out, static_cast<std::uint32_t>(value.size()));
  return out + std::string(value);
}

std::string chunk(const std::string& id, const std::string& content) {
  return id + numbers({static_cast<int>(content.size()), 0}) + content;
}

std::string file(const std::string& chunks) {
  return "VOX " + numbers({150}) + "MAIN" + numbers({0, static_cast<int>(chunks.size())}) + chunks;
}

// A model of the cells given as x, y, z, palette index.
std::string model(int x, int y, int z, const std::string& voxels) {
  return chunk("SIZE", numbers({x, y, z})) +
         chunk("XYZI", numbers({static_cast<int>(voxels.size() / 4)}) + voxels);
}

std::string transform(int id, int child, const std::string& frame) {
  return chunk("nTRN", numbers({id, 0, child, -1, -1, 1}) + frame);
}

std::string placed(int id, int child, const std::string& rotation, const std::string& shift) {
  return transform(id, child,
                   numbers({2}) + text("_r") + text(rotation) + text("_t") + text(shift));
}

std::string shape(int id, int number) { return chunk("nSHP", numbers({id, 0, 1, number, 0})); }

std::string vox_complaint(const std::string& bytes) {
  Diagnostics diagnostics;
  CHECK_FALSE(read_vox("m.vox", bytes, diagnostics).has_value());
  REQUIRE(diagnostics.all().size() == 1);
  return std::string(info(diagnostics.all()[0].code).name) + " " + diagnostics.all()[0].message;
}

LoadedStructure read_model(const std::string& bytes) {
  Diagnostics diagnostics;
  auto loaded = read_vox("m.vox", bytes, diagnostics);
  REQUIRE(loaded.has_value());
  return std::move(*loaded);
}

TEST_CASE("law: reading a print gives the structure, its places and its colours") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice(), 62, *rc::gen::element(2, 300));
    Diagnostics diagnostics;
    const auto back = read_vox("m", print_vox(s, {}), diagnostics, s.lattice());
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->structure == s);
    for (const PlacedBrick& brick : s.bricks()) {
      RC_ASSERT(rgb_of(back->bricks, brick.brick) == rgb_of({}, brick.brick));
    }
    RC_ASSERT(diagnostics.all().empty());
  }));
}

TEST_CASE("a structure too large for one model becomes several") {
  Structure s;
  for (int x = -300; x < 300; ++x) s.place({x, x / 2, 7}, 3);
  const std::string bytes = print_vox(s, numbered_bricks(3));
  CHECK(read_model(bytes).structure == s);
  CHECK(bytes.find("XYZI") != bytes.rfind("XYZI"));
}

TEST_CASE("the written file, byte for byte") {
  std::string palette;
  for (int i = 1; i <= 256; ++i) {
    const Rgb rgb = i <= 62 ? rgb_of({}, static_cast<Colour>(i)) : Rgb{128, 128, 128};
    for (const int value : {int{rgb.r}, int{rgb.g}, int{rgb.b}, 255}) {
      put(palette, static_cast<std::uint8_t>(value));
    }
  }
  Structure s;
  s.place({5, 0, 0}, 2);
  s.place({5, 1, 0}, 1);
  const std::string expected =
      file(model(1, 2, 1, std::string("\0\0\0\2\0\1\0\1", 8)) +
           chunk("nTRN", numbers({0, 0, 1, -1, -1, 1, 0})) + chunk("nGRP", numbers({1, 0, 1, 2})) +
           chunk("nTRN", numbers({2, 0, 3, -1, 0, 1, 1}) + text("_t") + text("5 1 0")) +
           shape(3, 0) + chunk("RGBA", palette));
  CHECK(print_vox(s, {}) == expected);
}

TEST_CASE("a file without a scene has its cells where the model has them") {
  const auto loaded = read_model(file(model(2, 1, 1, std::string("\1\0\0\1", 4))));
  CHECK(loaded.structure.at({1, 0, 0}) == 1);
  CHECK(loaded.bricks.size() == 1);
  CHECK(loaded.bricks[0].color == "#ffffff");
}

TEST_CASE("high palette indices are numbered anew, in order") {
  const auto loaded =
      read_model(file(model(2, 1, 1, std::string("\0\0\0\xff", 4) + std::string("\1\0\0\xd8", 4))));
  CHECK(loaded.structure.at({0, 0, 0}) == 2);
  CHECK(loaded.structure.at({1, 0, 0}) == 1);
  CHECK(loaded.bricks[0].color == "#ee0000");
  CHECK(loaded.bricks[1].color == "#111111");
}

TEST_CASE("models are turned and placed by the scene") {
  // Rows (0 -1 0), (1 0 0), (0 0 1): a quarter turn about the vertical, as the byte
  // 1 | 0 << 2 | 1 << 4. The model of 3 cells along x turns about its middle cell's
  // lower corner.
  const std::string chunks = model(3, 1, 1, std::string("\0\0\0\1\1\0\0\1\2\0\0\2", 12)) +
                             placed(0, 1, "17", "10 20 30") + shape(1, 0);
  const Structure s = read_model(file(chunks)).structure;
  CHECK(s.size() == 3);
  CHECK(s.at({9, 19, 30}) == 1);
  CHECK(s.at({9, 20, 30}) == 1);
  CHECK(s.at({9, 21, 30}) == 2);
}

TEST_CASE("transforms inside of transforms act from the inside out") {
  const std::string chunks = model(1, 1, 1, std::string("\0\0\0\1", 4)) +
                             placed(0, 1, "17", "0 0 5") + chunk("nGRP", numbers({1, 0, 1, 2})) +
                             placed(2, 3, "4", "10 0 0") + shape(3, 0);
  const Structure s = read_model(file(chunks)).structure;
  REQUIRE(s.size() == 1);
  CHECK(s.bricks()[0].at == Cell{-1, 10, 5});
}

TEST_CASE("rotations compose as matrices do") {
  CHECK(rc::check([] {
    const auto any = [] {
      VoxTransform t;
      t.axis = *rc::gen::element(std::array<std::uint8_t, 3>{0, 1, 2},
                                 std::array<std::uint8_t, 3>{1, 2, 0},
                                 std::array<std::uint8_t, 3>{2, 1, 0});
      for (auto& sign : t.sign) sign = *rc::gen::element<std::int8_t>(-1, 1);
      for (auto& shift : t.shift) shift = *rc::gen::inRange(-9, 10);
      return t;
    };
    const auto apply = [](const VoxTransform& t, std::array<std::int64_t, 3> v) {
      v = t.rotated(v);
      for (std::size_t i = 0; i < 3; ++i) v[i] += t.shift[i];
      return v;
    };
    const VoxTransform a = any(), b = any();
    const std::array<std::int64_t, 3> v = {1, 20, 300};
    RC_ASSERT(apply(a.after(b), v) == apply(a, apply(b, v)));
  }));
}

TEST_CASE("unknown chunks are passed over") {
  const auto bytes = file(chunk("PACK", numbers({1})) + chunk("MATL", "abc") +
                          model(1, 1, 1, std::string("\0\0\0\1", 4)) + chunk("NOTE", ""));
  CHECK(read_model(bytes).structure.size() == 1);
}

TEST_CASE("frames and overlaps are warned of") {
  Diagnostics diagnostics;
  const std::string two =
      model(1, 1, 1, std::string("\0\0\0\1", 4)) + model(1, 1, 1, std::string("\0\0\0\2", 4));
  CHECK(read_vox("m", file(two), diagnostics)->structure.size() == 1);
  const std::string scene = chunk("nGRP", numbers({0, 0, 2, 1, 2})) + shape(1, 0) + shape(2, 1);
  const auto loaded = read_vox("m", file(two + scene), diagnostics);
  REQUIRE(loaded.has_value());
  CHECK(loaded->structure.bricks()[0].brick == 1);
  REQUIRE(diagnostics.all().size() == 2);
  CHECK(diagnostics.all()[0].code == Code::F409);
  CHECK(diagnostics.all()[1].code == Code::F410);
}

TEST_CASE("damaged files are refused") {
  const std::string one = model(1, 1, 1, std::string("\0\0\0\1", 4));
  CHECK(vox_complaint("") == "F407 the file does not start with 'VOX '");
  CHECK(vox_complaint("VOX " + numbers({99}) + "MAIN") ==
        "F407 version 99 of the format is not known");
  CHECK(vox_complaint("VOX " + numbers({150})) == "F407 the chunk 'MAIN' is missing");
  CHECK(vox_complaint(file("")) == "F407 the file has no model");
  CHECK(vox_complaint(file(chunk("XYZI", numbers({0})))) == "F407 chunk 'XYZI' without 'SIZE'");
  CHECK(
      vox_complaint(file(chunk("SIZE", numbers({1, 1, -1})))).ends_with("within 256 cells a side"));
  CHECK(vox_complaint(file(model(1, 1, 1, std::string("\1\0\0\1", 4))))
            .ends_with("outside of its size"));
  CHECK(vox_complaint(file(chunk("SIZE", numbers({1, 1, 1})) + chunk("XYZI", numbers({-1}))))
            .ends_with("fewer cells than it says"));
  CHECK(vox_complaint(file(one + shape(0, 7))).ends_with("places model 8, but there are 1"));
  CHECK(vox_complaint(file(one + chunk("nSHP", ""))).find("damaged node") != std::string::npos);
  CHECK(vox_complaint(file(one + chunk("nGRP", numbers({0, 0, 999999999})))).starts_with("F407"));
  CHECK(vox_complaint(file(one + chunk("RGBA", "abc"))) == "F407 the palette is too short");
}

TEST_CASE("every cut of a good file is refused or read, never worse") {
  const std::string bytes = print_vox(structure_literal("1 2\n---\n. 3"), {});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Diagnostics diagnostics;
    const auto loaded = read_vox("m", bytes.substr(0, size), diagnostics);
    CHECK(loaded.has_value() == diagnostics.all().empty());
  }
}

TEST_CASE("scenes that are no trees are refused") {
  const std::string one = model(1, 1, 1, std::string("\0\0\0\1", 4));
  const std::string message = "F407 the scene is no tree, or reaches too far";
  CHECK(vox_complaint(file(one + transform(0, 0, numbers({0})))) == message);
  CHECK(vox_complaint(file(one + chunk("nGRP", numbers({0, 0, 2, 1, 1})) + shape(1, 0))) ==
        message);
  CHECK(vox_complaint(file(one + transform(0, 5, numbers({0})))) == message);
  CHECK(vox_complaint(file(one + shape(0, 0) + shape(0, 0))).find("damaged") != std::string::npos);
  CHECK(vox_complaint(file(one + placed(0, 1, "4", "99999999999 0 0") + shape(1, 0)))
            .starts_with("F407"));
  CHECK(vox_complaint(file(one + placed(0, 1, "4", "0 -9223372036854775808 0") + shape(1, 0)))
            .starts_with("F407"));
  CHECK(vox_complaint(file(one + placed(0, 1, "5", "0 0 0") + shape(1, 0))).starts_with("F407"));
}

TEST_CASE("more colours than a structure can have are refused") {
  std::string voxels;
  for (int i = 1; i <= 63; ++i) {
    for (const int value : {i, 0, 0, i + 100}) put(voxels, static_cast<std::uint8_t>(value));
  }
  CHECK(vox_complaint(file(model(64, 1, 1, voxels))) ==
        "F408 the models use 63 colours, the most is 62");
}

TEST_CASE("cells are counted as often as they are placed, the empty ones too") {
  const int cells = 1 << 18, shapes = 129;  // one placement more than 2^25 cells
  std::string scene, children;
  for (int i = 1; i <= shapes; ++i) {
    scene += shape(i, 0);
    children += numbers({i});
  }
  const auto bytes = [&](int placements) {
    const std::string some = children.substr(0, std::size_t{4} * static_cast<unsigned>(placements));
    return file(model(1, 1, 1, std::string(std::size_t{4} * cells, '\0')) +
                chunk("nGRP", numbers({0, 0, placements}) + some) + scene);
  };
  CHECK(vox_complaint(bytes(shapes)) == "F406 more than 33554432 cells");
  CHECK(read_model(bytes(1)).structure.size() == 0);
}

TEST_CASE("cells far out are refused") {
  const std::string one = model(1, 1, 1, std::string("\0\0\0\1", 4));
  CHECK(vox_complaint(file(one + placed(0, 1, "4", "20000000 0 0") + shape(1, 0)))
            .starts_with("F406"));
}

}  // namespace
}  // namespace stig
