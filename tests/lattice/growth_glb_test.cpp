// SPDX-License-Identifier: MIT
#include "lattice/growth_glb.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "lattice/mesh.h"
#include "lattice/rgb.h"
#include "support/any_structure.h"
#include "support/glb.h"
#include "support/uses.h"

namespace stig {
namespace {

using nlohmann::json;

std::size_t triangles_in(const json& file) {
  std::size_t corners = 0;
  if (!file.contains("meshes")) return 0;
  for (const json& mesh : file["meshes"]) {
    for (const json& primitive : mesh["primitives"]) {
      corners +=
          file["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>();
    }
  }
  return corners / 3;
}

/// Faces that are seen at some time, when bricks come one by one: of two that touch, that of the
/// first.
std::size_t triangles_ever_seen(const Structure& whole) {
  std::size_t all = 0, between = 0;
  for (const PlacedBrick& brick : whole.bricks()) {
    for (const CellFace& face : cell_faces(whole.lattice())) {
      const auto size = static_cast<std::size_t>(face.corners) - 2;
      all += size;
      if (whole.at(brick.at + face.towards) != kEmpty) between += size;
    }
  }
  return all - between / 2;
}

TEST_CASE("law: each face that is ever seen is in the file once") {
  CHECK(rc::check([] {
    const Structure whole = any_structure(any_lattice(), 3, 2);
    std::vector<GrowthStep> steps;
    for (const PlacedBrick& brick : whole.bricks()) {
      steps.push_back({static_cast<double>(steps.size()) / 4, {brick}});
    }
    const json file = glb_content(print_growth_glb(whole.lattice(), steps, {}));
    RC_ASSERT(triangles_in(file) == triangles_ever_seen(whole));
  }));
}

TEST_CASE("bricks of one moment share a node, and those from the beginning do not move") {
  const std::vector<GrowthStep> steps = {
      {0, {{{0, 0, 0}, 1}}}, {0.5, {{{1, 0, 0}, 1}, {{2, 0, 0}, 2}}}, {2, {{{3, 0, 0}, 1}}}};
  const json file = glb_content(print_growth_glb(Lattice::cubic, steps, numbered_bricks(2)));
  REQUIRE(file["nodes"].size() == 3);
  CHECK(file["nodes"][1]["name"] == "bricks 2-3");
  REQUIRE(file["animations"].size() == 1);
  const json& animation = file["animations"][0];
  REQUIRE(animation["channels"].size() == 2);
  CHECK(animation["channels"][1]["target"] == json{{"node", 2}, {"path", "scale"}});
  for (std::size_t i = 0; i < 2; ++i) {
    const json& sampler = animation["samplers"][i];
    CHECK(sampler["interpolation"] == "STEP");
    const json& times = file["accessors"][sampler["input"].get<std::size_t>()];
    CHECK(times["min"][0] == 0);
    CHECK(times["max"][0] == (i == 0 ? 0.5 : 2));
    CHECK(!file["bufferViews"][times["bufferView"].get<std::size_t>()].contains("target"));
  }
}

TEST_CASE("nothing grows into a file without nodes") {
  const json file = glb_content(print_growth_glb(Lattice::hexagonal, {}, {}));
  CHECK(!file.contains("nodes"));
  CHECK(!file.contains("animations"));
}

}  // namespace
}  // namespace stig
