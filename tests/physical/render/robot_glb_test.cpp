// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "physical/render/robot_picture.h"
#include "robots/robot_reader.h"
#include "support/uses.h"

namespace stig {
namespace {

/// The JSON chunk.
nlohmann::json content_of(const std::string& glb) {
  REQUIRE(glb.substr(0, 4) == "glTF");
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(glb[i]); };
  const std::size_t size = byte(12) | byte(13) << 8U | byte(14) << 16U;
  return nlohmann::json::parse(glb.substr(20, size));
}

/// Where a node stands in the scene: its parents' translations and turns, one after another.
Pose pose_of(const nlohmann::json& nodes, std::size_t node) {
  Pose own;
  if (nodes[node].contains("translation")) {
    const auto& p = nodes[node]["translation"];
    const auto& q = nodes[node]["rotation"];
    own = {{p[0], p[1], p[2]}, {q[3], q[0], q[1], q[2]}};
  }
  for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
    if (!nodes[parent].contains("children")) continue;
    for (const auto& child : nodes[parent]["children"]) {
      if (child == node) return pose_of(nodes, parent) * own;
    }
  }
  return own;
}

TEST_CASE("a robot's model has its bodies where they are, y up") {
  Diagnostics diagnostics;
  const auto robot = read_robot_file(STIG_SOURCE_DIR "/robots/bebot.yaml", diagnostics);
  REQUIRE(robot);
  const nlohmann::json json = content_of(robot_glb(*robot));
  const auto& nodes = json["nodes"];
  REQUIRE(nodes.size() == robot->bodies.size() + 2);
  CHECK(json["scenes"][0]["nodes"] == nlohmann::json({0}));
  std::size_t found = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const BodyModel& body : robot->bodies) {
      if (nodes[i]["name"] != body.name) continue;
      ++found;
      const Vec3 p = pose_of(nodes, i).p;
      CHECK(length(p - Vec3{body.X_RB.p.x, body.X_RB.p.z, -body.X_RB.p.y}) < 1e-9);
    }
  }
  CHECK(found == robot->bodies.size());
  CHECK(nodes.back()["name"] == "devices");
  CHECK(json["meshes"].back()["primitives"][0]["mode"] == 1);
}

}  // namespace
}  // namespace stig
