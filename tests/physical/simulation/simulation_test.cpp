// SPDX-License-Identifier: MIT
#include "physical/simulation/simulation.h"

#include "physical/scene/block_text.h"
#include "physical/simulation/checkpoint_file.h"
#include "physical/simulation/loaded_scene.h"
#include "physical/simulation/verify_trace.h"
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr const char* kLively =
    "stigc_scene: 1\nblocks:\n"
    "  - {grid: [2, 2, 3], at: [0, 0, 0.1], tumble: 20, jitter: 0.004}\n";

LoadedScene load(const std::string& text, std::uint64_t seed = 1) {
  Diagnostics diagnostics;
  auto loaded =
      load_scene({{"s.yaml", text}, {"stigmergic.yaml", block_text()}}, seed, diagnostics);
  INFO(to_text(diagnostics));
  REQUIRE(loaded);
  return std::move(*loaded);
}

struct Recorded {
  std::string trace;
  std::uint64_t hash = 0;
  RunTally tally;
  std::string state;
};

Recorded record(const LoadedScene& loaded, double duration) {
  Recorded out;
  Simulation run(loaded.scene, loaded.placed);
  PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                         [&](std::string_view b) { out.trace += b; });
  run.record(writer);
  run.finish(run.until(duration, {}));
  out.hash = run.world().hash();
  out.tally = run.tally();
  out.state = run.state();
  return out;
}

PoseTrace recorded_trace(const std::string& bytes) {
  Diagnostics diagnostics;
  auto trace = read_pose_trace("t.stigp", bytes, diagnostics);
  REQUIRE(trace);
  return std::move(*trace);
}

}  // namespace

TEST_CASE("interrupted anywhere and resumed: the same state, tally and bytes of the trace") {
  const LoadedScene loaded = load(kLively);
  const Recorded whole = record(loaded, 1.5);
  for (const double at : {0.005, 0.33, 0.5, 1.213}) {
    CAPTURE(at);
    const Recorded part = record(loaded, at);
    const PoseTrace earlier = recorded_trace(part.trace);
    Simulation run(loaded.scene, loaded.placed);
    REQUIRE(run.resume(part.state));
    std::string bytes;
    PoseTraceWriter writer(trace_header(loaded.scene, loaded.placed),
                           [&](std::string_view b) { bytes += b; });
    copy_records(earlier, run.world().tick(), writer);
    run.record(writer);
    run.finish(run.until(1.5, {}));
    CHECK(run.world().hash() == whole.hash);
    CHECK(run.tally() == whole.tally);
    CHECK(bytes == whole.trace);
  }
}

TEST_CASE("a recorded run comes out again, and another does not") {
  const LoadedScene loaded = load(kLively);
  const PoseTrace trace = recorded_trace(record(loaded, 2.3).trace);
  const TraceComparison same = verify_trace(trace, loaded, {});
  CHECK(same.identical);
  CHECK(same.compared == 3);
  const TraceComparison other = verify_trace(trace, load(kLively, 2), {});
  CHECK_FALSE(other.identical);
  CHECK(other.difference == "the state in tick 200 is another");
  // From the trace's own files alone.
  Diagnostics diagnostics;
  const auto embedded = load_scene(trace.header.files, trace.header.seed, diagnostics);
  REQUIRE(embedded);
  CHECK(verify_trace(trace, *embedded, {}).identical);
}

TEST_CASE("the trace holds what the world did") {
  const LoadedScene loaded = load(kLively);
  Simulation run(loaded.scene, loaded.placed);
  CHECK(run.until(0.5, {}) == RunEnd::duration);
  CHECK(run.world().tick() == 100);
  const PoseTrace trace = recorded_trace(record(loaded, 0.5).trace);
  CHECK(trace.end.ticks == 100);
  CHECK(trace.end.hash == run.world().hash());
  const TraceFrame frame = frame_at(trace, 100);
  for (std::uint32_t i = 0; i < run.world().size(); ++i) {
    CHECK(length(frame.bodies[i].pose().p - run.world().state(BodyId{i}).X_WB.p) < 1e-5);
  }
}

TEST_CASE("a run ends when all sleep, where the scene says so") {
  const LoadedScene loaded = load("stigc_scene: 1\nstop: {asleep: true}\nblocks: [{pyramid: 2}]\n");
  Simulation run(loaded.scene, loaded.placed);
  CHECK(run.until(10, {}) == RunEnd::asleep);
  CHECK(run.world().time() < 2);
  CHECK(run.tally().slept == 6);
}

TEST_CASE("a run that has come to rest makes no step more when it is brought back") {
  const LoadedScene loaded =
      load("stigc_scene: 1\nstop: {asleep: true}\nblocks: [{at: [0, 0, 0.03]}]\n");
  const Recorded whole = record(loaded, 20);
  Simulation run(loaded.scene, loaded.placed);
  REQUIRE(run.resume(whole.state));
  const std::uint64_t tick = run.world().tick();
  CHECK(run.until(30, {}) == RunEnd::asleep);
  CHECK(run.world().tick() == tick);
  CHECK(run.world().hash() == whole.hash);
}

TEST_CASE("what leaves the arena is counted, and the run goes on") {
  const LoadedScene loaded = load(
      "stigc_scene: 1\narena: 1\nblocks: [{at: [0, 0, 0.5], velocity: [20, 0, 0]}, {at: [0, 0.5, "
      "0.0275]}]\n");
  const Recorded run = record(loaded, 1);
  CHECK(run.tally.left == std::vector<std::uint32_t>{0});
  const PoseTrace trace = recorded_trace(run.trace);
  CHECK(trace.end.ticks == 200);
  CHECK(frame_at(trace, 200).bodies[0].left);
}

TEST_CASE("a stop ends the run between steps") {
  const LoadedScene loaded = load(kLively);
  Simulation run(loaded.scene, loaded.placed);
  std::atomic<bool> stop{false};
  RunHooks hooks;
  hooks.stop = &stop;
  hooks.after_step = [&](const World& world) { stop = world.tick() == 10; };
  CHECK(run.until(1, hooks) == RunEnd::interrupted);
  CHECK(run.world().tick() == 10);
}

TEST_CASE("checkpoints: back and forth, and what is none") {
  const LoadedScene loaded = load(kLively);
  const Recorded run = record(loaded, 0.4);
  const std::string bytes = checkpoint_bytes({loaded.scene.files, 1, run.state});
  std::string problem;
  const auto back = read_checkpoint_file(bytes, problem);
  REQUIRE(back);
  CHECK(back->state == run.state);
  CHECK(back->files.size() == 2);
  for (std::size_t i = 0; i < bytes.size(); i += 7) {
    std::string bad = bytes;
    bad[i] = static_cast<char>(bad[i] ^ 0x20);
    problem.clear();
    const auto read = read_checkpoint_file(bad, problem);
    // A bit that no decoder looks at does no harm.
    if (read) CHECK(read->state == run.state);
    CHECK(problem.empty() == read.has_value());
    CHECK_FALSE(read_checkpoint_file(bytes.substr(0, i), problem));
  }
  const LoadedScene other = load(kLively, 2);
  Simulation wrong(other.scene, other.placed);
  CHECK_FALSE(wrong.resume(run.state));
  CHECK_FALSE(wrong.resume(""));
  CHECK_FALSE(wrong.resume(run.state.substr(0, run.state.size() - 1)));
}
