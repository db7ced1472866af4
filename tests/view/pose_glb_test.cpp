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
  REQUIRE(nodes.size() == 4);
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

TEST_CASE("a part of a run begins at 0 s, at its own speed, with the colours of the end") {
  const json file = glb_content(pose_glb(small_trace(), {0.5, 1.5, 2}));
  const json sampler = channel_of(file, 2, "translation");
  const json& times = file["accessors"][sampler["input"].get<std::size_t>()];
  CHECK(times["min"][0] == 0);
  CHECK(times["max"][0] == 0.5);
  const auto material = [&](std::size_t node) {
    const json& mesh = file["meshes"][file["nodes"][node]["mesh"].get<std::size_t>()];
    return file["materials"][mesh["primitives"][0]["material"].get<std::size_t>()]["name"];
  };
  CHECK(material(1) == "#b0b4ba");
  CHECK(material(3) != material(1));
}

}  // namespace
}  // namespace stig
