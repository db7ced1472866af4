// SPDX-License-Identifier: MIT
#include "view/pose_glb.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "support/glb.h"
#include "support/uses.h"

namespace stig {
namespace {

using nlohmann::json;

BodyState state_of(const Vec3& p, double yaw, bool left) {
  BodyState state;
  state.X_WB = {p, rotation({0, 0, yaw})};
  state.left = left;
  return state;
}

/// Four bodies for 2 s: one that rests, one that goes and turns, one that comes, one that never
/// does.
PoseTrace small_trace() {
  PoseTraceHeader header;
  header.title = "four";
  header.step = 0.005;
  header.channels = {"leds"};
  for (const char* name : {"rests", "drives", "comes", "nowhere"}) {
    TraceBody body;
    body.name = name;
    body.block = true;
    body.shape = Shape::box({0.055, 0.055, 0.055});
    header.bodies.push_back(body);
  }
  header.files = {{"s.yaml", "stigc_scene: 1\n"}};
  std::string bytes;
  PoseTraceWriter writer(header, [&](std::string_view more) { bytes += more; });
  for (std::uint64_t tick = 0; tick <= 400; tick += 4) {
    const double time = static_cast<double>(tick) * header.step;
    TraceFrame frame{tick, {}};
    frame.bodies.push_back(trace_state(state_of({0, 0, 0}, 0, false)));
    frame.bodies.push_back(
        trace_state(state_of({0.2 * time, -0.1 * time, 0.03}, 0.5 * time, false)));
    frame.bodies.push_back(trace_state(state_of({0.2, 0, 0}, 0, time < 1)));
    frame.bodies.push_back(trace_state(state_of({0, 0, 0}, 0, true)));
    writer.frame(frame);
    if (tick == 200) writer.value({tick, 0, 2, "111111111111111111111111"});
  }
  writer.finish({400, RunEnd::duration, 0, ""});
  Diagnostics diagnostics;
  auto trace = read_pose_trace("t.stigp", std::move(bytes), diagnostics);
  REQUIRE(trace);
  return std::move(*trace);
}

/// The channel that moves a part of a node; null when there is none.
json channel_of(const json& file, std::size_t node, const std::string& path) {
  for (const json& channel : file["animations"][0]["channels"]) {
    if (channel["target"] == json{{"node", node}, {"path", path}}) {
      return file["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
    }
  }
  return {};
}

TEST_CASE("bodies that move have keys, those that rest none, those that never come no node") {
  const json file = glb_content(pose_glb(small_trace(), {0, 2, 1}));
  const json& nodes = file["nodes"];
  REQUIRE(nodes.size() == 6);  // with a child for each colour that one shows
  CHECK(nodes[1]["name"] == "rests");
  CHECK(nodes[2]["name"] == "drives");
  CHECK(nodes[3]["name"] == "comes");
  CHECK(channel_of(file, 1, "translation").is_null());
  const json drives = channel_of(file, 2, "rotation");
  REQUIRE(!drives.is_null());
  CHECK(drives["interpolation"] == "LINEAR");
  const json& times = file["accessors"][drives["input"].get<std::size_t>()];
  CHECK(times["min"][0] == 0);
  CHECK(times["max"][0] == 2);
  CHECK(times["count"] > 2);
  CHECK(times["count"] < 50);  // of 101 frames
  CHECK(channel_of(file, 2, "scale").is_null());
  const json comes = channel_of(file, 3, "scale");
  REQUIRE(!comes.is_null());
  CHECK(comes["interpolation"] == "STEP");
  CHECK(file["accessors"][comes["input"].get<std::size_t>()]["max"][0] == 1);
}

json material_of(const json& file, std::size_t node) {
  const json& mesh = file["meshes"][file["nodes"][node]["mesh"].get<std::size_t>()];
  return file["materials"][mesh["primitives"][0]["material"].get<std::size_t>()]["name"];
}

TEST_CASE("a part of a run begins at 0 s, at its own speed") {
  const json file = glb_content(pose_glb(small_trace(), {0.5, 1.5, 2}));
  const json sampler = channel_of(file, 2, "translation");
  const json& times = file["accessors"][sampler["input"].get<std::size_t>()];
  CHECK(times["min"][0] == 0);
  CHECK(times["max"][0] == 0.5);
  CHECK(material_of(file, 1) == "#b0b4ba");
}

TEST_CASE("a block that changes its LEDs is a surface of each colour, one there at a time") {
  const json file = glb_content(pose_glb(small_trace(), {0, 2, 1}));
  const json& nodes = file["nodes"];
  REQUIRE(nodes.size() == 6);
  CHECK(nodes[3]["name"] == "comes");
  CHECK(!nodes[3].contains("mesh"));
  CHECK(nodes[3]["children"] == json{4, 5});
  CHECK(material_of(file, 4) == "#b0b4ba");
  CHECK(material_of(file, 5) != material_of(file, 4));
  for (const std::size_t node : {4, 5}) {
    const json scale = channel_of(file, node, "scale");
    REQUIRE(!scale.is_null());
    CHECK(scale["interpolation"] == "STEP");
    CHECK(file["accessors"][scale["input"].get<std::size_t>()]["max"][0] == 1);
  }
  // After the change there is but one.
  const json late = glb_content(pose_glb(small_trace(), {1.2, 2, 1}));
  CHECK(late["nodes"].size() == 4);
  CHECK(material_of(late, 3) == material_of(file, 5));
}

TEST_CASE("what is outside of a slice is not there, and a palette lights the LEDs") {
  PoseLook look;
  look.shown = [](const Vec3& place) { return place.x > 0.1; };
  look.glow = [](Led) { return Rgb{0, 0, 0}; };
  const json file = glb_content(pose_glb(small_trace(), {0, 2, 1}, look));
  const json& nodes = file["nodes"];
  REQUIRE(nodes.size() == 5);  // without the one that rests at 0
  CHECK(nodes[1]["name"] == "drives");
  const json scale = channel_of(file, 1, "scale");
  REQUIRE(!scale.is_null());
  // At 0.2 m/s it is beyond 0.1 m after the frame of 0.5 s.
  const json& times = file["accessors"][scale["input"].get<std::size_t>()];
  CHECK(times["count"] == 2);
  CHECK(times["max"][0] == doctest::Approx(0.52));
  CHECK(material_of(file, 4) == to_color(blend({0xb0, 0xb4, 0xba}, {0, 0, 0}, 0.6)));
}

}  // namespace
}  // namespace stig
