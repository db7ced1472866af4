// SPDX-License-Identifier: MIT
// What is done by hand: what it does, what refuses it, and that a replay does it again.
#include <doctest/doctest.h>

#include "physical/robots/crew_support.h"
#include "physical/simulation/verify_trace.h"

namespace stig {
namespace {

LoadedScene two_blocks() {
  return crew_scene(
      "stigc_scene: 1\n"
      "duration: 3\n"
      "robots: [{file: bebot.yaml, name: r, program: p.lua}]\n"
      "blocks: [{at: [0.4, 0, 0.0275]}, {at: [-0.4, 0, 0.0275], fixed: true}]\n"
      "stock: 1\n",
      {{"p.lua",
        "function step()\n"
        "  robot.differential_drive.set_target_velocity(0.05, -0.05)\n"
        "end\n"}});
}

HandAction place(bool robot, std::uint32_t number, const Vec3& at) {
  HandAction out;
  out.robot = robot;
  out.number = number;
  out.at = at;
  return out;
}
HandAction act(HandKind kind, const Vec3& at = {}) {
  HandAction out;
  out.kind = kind;
  out.robot = kind != HandKind::drop;
  out.at = at;
  return out;
}

/// A run in which a hand does much, and its trace.
std::string handled(const LoadedScene& loaded, std::uint64_t& hash) {
  std::string out;
  Simulation run(loaded.scene, loaded.placed);
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view bytes) { out += bytes; });
  run.record(writer);
  CHECK(run.intervene(place(false, 0, {0.3, 0.3, 0.2})) == "");
  CHECK(run.until(0.5, {}) == RunEnd::duration);
  CHECK(run.intervene(act(HandKind::halt)) == "");
  CHECK(run.until(1, {}) == RunEnd::duration);
  CHECK(run.intervene(act(HandKind::mend)) == "");
  HandAction turned = place(true, 0, {-0.1, 0.1, 0});
  turned.turn = rotation({0, 0, 1.2});
  CHECK(run.intervene(turned) == "");
  CHECK(run.intervene(act(HandKind::drop, {0, 0.6, 0.3})) == "");
  const RunEnd end = run.until(2, {});
  CHECK(run.intervene(place(false, 0, {0.1, 0.6, 0.0275})) == "");
  run.finish(end);
  hash = run.hash();
  return out;
}

TEST_CASE("what was done by hand is in the trace, and is done again on replay") {
  const LoadedScene loaded = two_blocks();
  std::uint64_t hash = 0;
  PoseTrace trace = trace_of(handled(loaded, hash));
  REQUIRE(trace.hands.size() == 6);
  CHECK(trace.hands[0].tick == 0);
  CHECK(trace.hands[1].tick == 100);
  CHECK(trace.hands[3].action.turn.has_value());
  CHECK(trace.end.hash == hash);
  const TraceComparison report = verify_trace(trace, loaded, {});
  CHECK_MESSAGE(report.identical, report.difference);
  // Each of them counts: without one the run is another.
  for (std::size_t i = 0; i < 6; ++i) {
    PoseTrace without = trace;
    without.hands.erase(without.hands.begin() + static_cast<std::ptrdiff_t>(i));
    CAPTURE(i);
    CHECK(!verify_trace(without, loaded, {}).identical);
  }
  trace.hands[0].action.number = 1;
  CHECK(verify_trace(trace, loaded, {}).difference ==
        "what was done by hand in tick 0 cannot be done again: it is fixed in the world");
}

TEST_CASE("a record of a hand that is damaged is no trace") {
  const LoadedScene loaded = two_blocks();
  const auto written = [&](const HandAction& action) {
    std::string out;
    PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                           [&](std::string_view bytes) { out += bytes; });
    Simulation run(loaded.scene, loaded.placed);
    run.record(writer);
    writer.hand({0, action});
    run.finish(RunEnd::duration);
    Diagnostics diagnostics;
    return read_pose_trace("t.stigp", out, diagnostics).has_value();
  };
  CHECK(written(place(false, 0, {1, 2, 3})));
  CHECK(!written(place(false, 100'000, {1, 2, 3})));
  CHECK(!written(place(false, 0, {NAN, 2, 3})));
  HandAction turned = place(false, 0, {});
  turned.turn = Quat{2, 0, 0, 0};
  CHECK(!written(turned));
  HandAction unknown;
  unknown.kind = static_cast<HandKind>(4);
  CHECK(!written(unknown));
}

TEST_CASE("a hand is refused what cannot be, and the run stays as it was") {
  const LoadedScene loaded = two_blocks();
  Simulation run(loaded.scene, loaded.placed);
  const std::uint64_t hash = run.hash();
  CHECK(run.intervene(place(false, 7, {})) == "there is no such block");
  CHECK(run.intervene(place(false, 2, {})) == "there is no such block");
  CHECK(run.intervene(place(true, 1, {})) == "there is no such robot");
  CHECK(run.intervene(place(false, 0, {-0.4, 0, 0.0275})) == "'block 1' would overlap 'block 2'");
  CHECK(run.intervene(act(HandKind::mend)) == "nothing is wrong with it");
  CHECK(run.intervene(act(HandKind::drop, {0.4, 0, 0.0275})) == "it would overlap 'block 1'");
  CHECK(run.hash() == hash);
  CHECK(run.intervene(act(HandKind::halt)) == "");
  CHECK(run.intervene(act(HandKind::halt)) == "it stands still already");
  CHECK(run.intervene(act(HandKind::drop, {0.4, 0, 0.3})) == "");
  CHECK(run.intervene(act(HandKind::drop, {0.4, 0, 0.5})) == "the scene's stock is used up");
}

TEST_CASE("records up to a checkpoint take what was done by hand before it") {
  const LoadedScene loaded = two_blocks();
  std::uint64_t hash = 0;
  const PoseTrace trace = trace_of(handled(loaded, hash));
  const auto copied = [&](std::uint64_t tick, std::optional<std::size_t> hands) {
    std::string out;
    PoseTraceWriter writer(trace.header, [&](std::string_view bytes) { out += bytes; });
    copy_records(trace, tick, writer, hands);
    writer.finish({tick, RunEnd::interrupted, 0, ""});
    return trace_of(out).hands.size();
  };
  CHECK(copied(200, std::nullopt) == 2);
  CHECK(copied(200, 4) == 4);
}

}  // namespace
}  // namespace stig
