// SPDX-License-Identifier: MIT
#include "view/pose_mcap.h"

#include <doctest/doctest.h>

#include "physical/trace/pose_frames.h"
#include "support/mcap.h"
#include "support/uses.h"

namespace stig {
namespace {

using nlohmann::json;

TraceState mcap_state(const Vec3& p, double yaw, bool left) {
  BodyState state;
  state.X_WB = {p, rotation({0, 0, yaw})};
  state.left = left;
  return trace_state(state);
}

TraceBody mcap_body(const std::string& name, Shape shape, bool block) {
  TraceBody body;
  body.name = name;
  body.shape = std::move(shape);
  body.block = block;
  return body;
}

/// A body of each shape for `ticks` of 5 ms: a block that changes its light, two of one name, one
/// that comes after a second.
std::string mcap_trace_bytes(std::uint64_t ticks) {
  PoseTraceHeader header;
  header.title = "shapes";
  header.seed = 7;
  header.channels = {"leds", "log"};
  header.bodies = {
      mcap_body("block 1", Shape::box({0.055, 0.055, 0.05}), true),
      mcap_body("cart/wheel", Shape::cylinder(0.03, 0.012), false),
      mcap_body("cart/wheel", Shape::sphere(0.01), false),
      mcap_body("world", Shape::hull({{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}), false)};
  header.bodies[1].rgb = {255, 0, 51};
  std::string bytes;
  PoseTraceWriter writer(header, [&](std::string_view more) { bytes += more; });
  for (std::uint64_t tick = 0; tick <= ticks; tick += 4) {
    const double time = static_cast<double>(tick) * header.step;
    writer.frame({tick,
                  {mcap_state({0.1, -0.2, 0.025}, 0, false),
                   mcap_state({0.1 * time, 0, 0.03}, 0.5 * time, false),
                   mcap_state({0, 1, 0.5}, 0, false), mcap_state({0, 0, 1}, 0, time < 1)}});
    if (tick == 40) writer.event({41, {EventKind::snapped, BodyId{0}, BodyId{3}}});
    if (tick == 40) writer.value({42, 1, 1, "said \"this\"\xff"});
    if (tick == 80) writer.value({80, 0, 0, "111111111111111111111111"});
    if (tick == 120) writer.event({121, {EventKind::left_arena, BodyId{2}, kFloorId}});
    if (tick == 120) writer.event({122, {EventKind::contact_began, BodyId{2}, kFloorId}});
  }
  writer.finish({ticks, RunEnd::failed, 0xabc, "no more"});
  return bytes;
}

PoseTrace mcap_trace(std::uint64_t ticks) {
  Diagnostics diagnostics;
  auto trace = read_pose_trace("t.stigp", mcap_trace_bytes(ticks), diagnostics);
  REQUIRE(trace);
  return std::move(*trace);
}

std::string mcap_bytes(const PoseTrace& trace) {
  std::string out;
  write_pose_mcap(trace, [&](std::string_view piece) {
    out += piece;
    return true;
  });
  return out;
}

double seconds_of(const json& stamp) {
  return stamp["sec"].get<double>() + stamp["nsec"].get<double>() * 1e-9;
}

TEST_CASE("each frame has the poses of all that are there, in the world's frame") {
  const PoseTrace trace = mcap_trace(400);
  const McapContent content = mcap_content(mcap_bytes(trace));
  CHECK(content.schemas == std::map<std::string, std::string>{{"/tf", "foxglove.FrameTransforms"},
                                                              {"/scene", "foxglove.SceneUpdate"},
                                                              {"/log", "foxglove.Log"}});
  CHECK(content.facts.at("title") == "shapes");
  CHECK(content.facts.at("seed") == "7");
  CHECK(content.facts.at("ended") == "failed");
  const auto poses = content.of("/tf");
  CHECK(poses.size() == trace.frames);
  const std::vector<std::string> names = {"block 1", "cart/wheel", "cart/wheel #2", "world #3"};
  std::size_t number = 0;
  for_each_frame(trace, [&](const TraceFrame& frame) {
    const auto& message = poses[number++];
    CHECK(message.time == frame.tick * 5'000'000);
    std::size_t next = 0;
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      if (frame.bodies[i].left) continue;
      const json& one = message.content["transforms"][next++];
      const Pose pose = frame.bodies[i].pose();
      CHECK(one["parent_frame_id"] == "world");
      CHECK(one["child_frame_id"] == names[i]);
      CHECK(seconds_of(one["timestamp"]) == doctest::Approx(static_cast<double>(frame.tick) / 200));
      const json& p = one["translation"];
      CHECK(length(Vec3{p["x"], p["y"], p["z"]} - pose.p) < 1e-9);
      const json& q = one["rotation"];
      CHECK(std::abs(q["w"].get<double>() - pose.q.w) < 1e-6);
      CHECK(std::abs(q["z"].get<double>() - pose.q.z) < 1e-6);
    }
    CHECK(message.content["transforms"].size() == next);
  });
}

TEST_CASE("the scene is told whole: at the start, when a light changes, when something comes") {
  const auto scenes = mcap_content(mcap_bytes(mcap_trace(400))).of("/scene");
  REQUIRE(scenes.size() == 3);
  CHECK(scenes[0].time == 0);
  CHECK(scenes[1].time == 400'000'000);
  CHECK(scenes[2].time == 1'000'000'000);
  for (const auto& scene : scenes) {
    REQUIRE(scene.content["deletions"].size() == 1);
    CHECK(scene.content["deletions"][0]["type"] == 1);
  }
  const json& first = scenes[0].content["entities"];
  REQUIRE(first.size() == 3);
  const json& cube = first[0]["cubes"][0];
  CHECK(cube["size"] == json{{"x", 0.055}, {"y", 0.055}, {"z", 0.05}});
  const json& wheel = first[1];
  CHECK(wheel["frame_id"] == "cart/wheel");
  CHECK(wheel["frame_locked"] == true);
  CHECK(wheel["cylinders"][0]["size"] == json{{"x", 0.06}, {"y", 0.06}, {"z", 0.012}});
  CHECK(wheel["cylinders"][0]["color"] == json{{"r", 1}, {"g", 0}, {"b", 0.2}, {"a", 1}});
  CHECK(first[2]["spheres"][0]["size"] == json{{"x", 0.02}, {"y", 0.02}, {"z", 0.02}});
  CHECK(scenes[1].content["entities"][0]["cubes"][0]["color"] != cube["color"]);
  const json& last = scenes[2].content["entities"];
  REQUIRE(last.size() == 4);
  CHECK(last[3]["id"] == "world #3");
  CHECK(last[3]["triangles"][0]["points"].size() == 12);
}

TEST_CASE("log lines: programs' words, events, and how it ended, in the order of time") {
  const auto lines = mcap_content(mcap_bytes(mcap_trace(400))).of("/log");
  std::string all;
  std::uint64_t last = 0;
  for (const auto& line : lines) {
    CHECK(line.time >= last);
    last = line.time;
    all += line.content["level"].dump() + " " + line.content["name"].get<std::string>() + ": " +
           line.content["message"].get<std::string>() + "\n";
  }
  CHECK(all ==
        "2 block 1: snapped together with world #3\n"
        "2 cart/wheel: said \"this\"\xef\xbf\xbd\n"
        "3 cart/wheel #2: left the arena\n"
        "1 cart/wheel #2: touches the floor\n"
        "4 world: the run ended: failed: no more\n");
}

TEST_CASE("a long run is many chunks, the same bytes each time, and ends when it is not wanted") {
  const PoseTrace trace = mcap_trace(40'000);
  const std::string bytes = mcap_bytes(trace);
  const McapContent content = mcap_content(bytes);
  CHECK(content.chunks > 3);
  CHECK(content.of("/tf").size() == trace.frames);
  CHECK(bytes == mcap_bytes(trace));
  std::size_t pieces = 0, largest = 0;
  write_pose_mcap(trace, [&](std::string_view piece) {
    largest = std::max(largest, piece.size());
    ++pieces;
    return true;
  });
  CHECK(largest < bytes.size() / 2);
  std::size_t taken = 0;
  write_pose_mcap(trace, [&](std::string_view) { return ++taken < 3; });
  CHECK(taken == 3);
  CHECK(pieces > 3);
}

}  // namespace
}  // namespace stig
