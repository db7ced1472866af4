// SPDX-License-Identifier: MIT
#include "lattice/mesh_files.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <bit>
#include <nlohmann/json.hpp>

#include "base/bytes.h"
#include "lattice/rgb.h"
#include "lattice/structure_text.h"
#include "support/any_structure.h"
#include "support/uses.h"

namespace stig {
namespace {

float read_float(ByteReader& in) { return std::bit_cast<float>(in.u32()); }

struct Glb {
  nlohmann::json json;
  std::string_view binary;
};

Glb parse_glb(const std::string& bytes) {
  ByteReader in(bytes);
  REQUIRE(in.take(4) == "glTF");
  REQUIRE(in.u32() == 2);
  REQUIRE(in.u32() == bytes.size());
  const std::uint32_t size = in.u32();
  REQUIRE(in.take(4) == "JSON");
  Glb glb{nlohmann::json::parse(in.take(size)), {}};
  if (in.left() == 0) return glb;
  const std::uint32_t binary = in.u32();
  REQUIRE(in.take(4) == std::string_view("BIN\0", 4));
  glb.binary = in.take(binary);
  REQUIRE(in.good());
  REQUIRE(in.left() == 0);
  return glb;
}

TEST_CASE("STL: header, count, and triangles of 50 bytes") {
  const Mesh mesh = surface(structure_literal("1 1"), Merging::none);
  const std::string bytes = print_stl(mesh);
  CHECK(bytes.size() == 84 + 50 * 20);
  CHECK_FALSE(bytes.starts_with("solid"));
  ByteReader in(bytes);
  in.take(80);
  CHECK(in.u32() == 20);
  CHECK(read_float(in) == 1);  // the first face looks along +x
  in.take(8);
  CHECK(read_float(in) == 1.5F);  // and is that of the cell (1, 0, 0)
}

TEST_CASE("PLY: a header that says what follows") {
  const std::string bytes = print_ply(surface(structure_literal("1"), Merging::faces), {}, 0.055);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment made by stigc, 0.055 units a cell, z up\n"
      "element vertex 24\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  REQUIRE(bytes.starts_with(header));
  CHECK(bytes.size() == header.size() + 24 * 27 + 6 * 17);
  ByteReader in(std::string_view(bytes).substr(header.size()));
  CHECK(read_float(in) == 0.055F / 2);
}

TEST_CASE("glTF: colours in linear light, named materials, y up") {
  std::vector<Brick> bricks = numbered_bricks(2);
  bricks[1].name = "wax";
  bricks[1].color = "#ff8000";
  const Glb glb =
      parse_glb(print_glb(surface(structure_literal("2\n---\n2"), Merging::faces), bricks));
  CHECK(glb.json["asset"]["generator"] == "stigc");
  REQUIRE(glb.json["materials"].size() == 1);
  CHECK(glb.json["materials"][0]["name"] == "wax");
  const auto& colour = glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  CHECK(colour[0] == 1.0);
  CHECK(std::abs(colour[1].get<double>() - 0.2158605) < 1e-6);
  CHECK(colour[2] == 0.0);
  CHECK(glb.json["accessors"][0]["min"] == nlohmann::json({-0.5, 0.0, -0.5}));
  CHECK(glb.json["accessors"][0]["max"] == nlohmann::json({0.5, 2.0, 0.5}));
}

TEST_CASE("glTF: an empty structure is a valid, empty scene") {
  const Glb glb = parse_glb(print_glb({}, {}));
  CHECK(glb.json["scenes"] == nlohmann::json::array({nlohmann::json::object()}));
  CHECK_FALSE(glb.json.contains("buffers"));
  CHECK_FALSE(glb.json.contains("meshes"));
}

TEST_CASE("law: glTF's views lie aligned in the buffer, and all triangles are there") {
  CHECK(rc::check([] {
    const Structure s = any_structure(any_lattice());
    RC_PRE(!s.empty());
    const Mesh mesh = surface(s, Merging::faces);
    const std::string bytes = print_glb(mesh, {});
    RC_ASSERT(bytes.size() % 4 == 0);
    const Glb glb = parse_glb(bytes);
    std::size_t end = 0, corners = 0;
    for (const auto& view : glb.json["bufferViews"]) {
      RC_ASSERT(view["byteOffset"] == end);
      RC_ASSERT(end % 4 == 0);
      end += view["byteLength"].get<std::size_t>();
    }
    RC_ASSERT(end == glb.binary.size());
    for (const auto& primitive : glb.json["meshes"][0]["primitives"]) {
      corners += glb.json["accessors"][primitive["indices"].get<std::size_t>()]["count"]
                     .get<std::size_t>();
    }
    RC_ASSERT(corners == 3 * mesh.triangles());
  }));
}

}  // namespace
}  // namespace stig
