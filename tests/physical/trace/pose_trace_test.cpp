// SPDX-License-Identifier: MIT
#include "physical/trace/pose_trace.h"

#include <rapidcheck.h>

#include "base/random.h"
#include "physical/simulation/simulation.h"
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

PoseTraceHeader small_header(std::size_t bodies) {
  PoseTraceHeader header;
  header.title = "test";
  header.channels = {"led"};
  for (std::size_t i = 0; i < bodies; ++i) {
    TraceBody body;
    body.name = "body " + std::to_string(i);
    body.shape = Shape::box({0.055, 0.055, 0.055});
    header.bodies.push_back(body);
  }
  header.files = {{"s.yaml", "stigc_scene: 1\n"}};
  return header;
}

/// A frame in which some bodies have moved since the one before.
TraceFrame next_frame(const TraceFrame& last, Random& random) {
  TraceFrame frame = last;
  frame.tick += 4;
  for (TraceState& body : frame.bodies) {
    if (random.below(3) != 0) continue;
    BodyState state;
    const auto noise = [&random] { return 2 * random.unit() - 1; };
    state.X_WB = {{noise(), noise(), noise()},
                  normalised(Quat{noise(), noise(), noise(), noise()})};
    state.awake = random.below(2) == 0;
    state.left = random.below(9) == 0;
    body = trace_state(state);
  }
  return frame;
}

struct Written {
  std::string bytes;
  std::vector<TraceFrame> frames;
};

Written write(std::uint64_t seed, std::size_t bodies, std::size_t frames) {
  Random random(seed, 0, Purpose::test, 0, 0);
  Written out;
  PoseTraceWriter writer(small_header(bodies), [&](std::string_view b) { out.bytes += b; });
  TraceFrame frame;
  for (std::size_t i = 0; i < bodies; ++i) frame.bodies.push_back(trace_state({}));
  for (std::size_t i = 0; i < frames; ++i) {
    if (i > 0) frame = next_frame(frame, random);
    out.frames.push_back(frame);
    writer.frame(frame);
    if (bodies == 0) continue;
    writer.event({frame.tick + 1, {EventKind::snapped, BodyId{0}, kFloorId}});
    writer.hash({frame.tick + 2, random.next()});
    writer.value({frame.tick + 2, 0, 0, i % 2 == 0 ? "on" : "off"});
  }
  writer.finish({frame.tick + 3, RunEnd::asleep, 99, "done"});
  return out;
}

std::optional<PoseTrace> read(std::string bytes) {
  Diagnostics diagnostics;
  auto trace = read_pose_trace("t.stigp", std::move(bytes), diagnostics);
  CHECK(trace.has_value() != diagnostics.has_errors());
  return trace;
}

/// A trace's records, written again.
std::string contents(const PoseTrace& trace) {
  std::string out;
  PoseTraceWriter writer(trace.header, [&](std::string_view b) { out += b; });
  copy_records(trace, UINT64_MAX, writer);
  writer.finish(trace.end);
  return out;
}

bool same_pose(const TraceState& a, const TraceState& b) {
  const auto opposite = [](std::int64_t x, std::int64_t y) { return x == -y; };
  return a.place == b.place && a.awake == b.awake && a.left == b.left &&
         (a.turn == b.turn || std::equal(a.turn.begin(), a.turn.end(), b.turn.begin(), opposite));
}

}  // namespace

TEST_CASE("what is written comes back, at any moment") {
  CHECK(rc::check([] {
    const auto bodies = *rc::gen::inRange<std::size_t>(0, 6);
    const auto frames = *rc::gen::inRange<std::size_t>(1, 600);
    const Written written = write(*rc::gen::arbitrary<std::uint64_t>(), bodies, frames);
    const auto trace = read(written.bytes);
    RC_ASSERT(trace.has_value());
    RC_ASSERT(trace->frames == frames);
    RC_ASSERT(trace->events.size() == (bodies == 0 ? 0 : frames));
    RC_ASSERT(trace->hashes.size() == trace->events.size());
    RC_ASSERT(trace->end.why == RunEnd::asleep);
    RC_ASSERT(trace->end.message == "done");
    RC_ASSERT(trace->header.bodies.size() == bodies);
    const auto i = *rc::gen::inRange<std::size_t>(0, frames);
    const TraceFrame frame = frame_at(*trace, written.frames[i].tick + *rc::gen::inRange(0, 4));
    RC_ASSERT(frame.tick == written.frames[i].tick);
    RC_ASSERT(std::equal(frame.bodies.begin(), frame.bodies.end(), written.frames[i].bodies.begin(),
                         written.frames[i].bodies.end(), same_pose));
  }));
}

TEST_CASE("a pose comes back to 10 µm and 0.01 degrees") {
  Random random(5, 0, Purpose::test, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const auto noise = [&random] { return 2 * random.unit() - 1; };
    BodyState state;
    state.X_WB = {{noise(), noise(), noise()},
                  normalised(Quat{noise(), noise(), noise(), noise()})};
    const Pose back = trace_state(state).pose();
    CHECK(length(back.p - state.X_WB.p) < 1e-5);
    const Mat3 a = matrix(back.q), b = matrix(state.X_WB.q);
    for (int axis = 0; axis < 3; ++axis) CHECK(length(a.column(axis) - b.column(axis)) < 1.75e-4);
  }
}

TEST_CASE("a value of a channel that the header has not is refused") {
  for (const std::uint32_t channel : {0U, 1U, 0xffffU}) {
    std::string bytes;
    PoseTraceWriter writer(small_header(1), [&](std::string_view b) { bytes += b; });
    writer.frame({0, {trace_state({})}});
    writer.value({1, channel, 0, "on"});
    writer.finish({2, RunEnd::duration, 0, ""});
    CHECK(read(bytes).has_value() == (channel == 0));
  }
}

TEST_CASE("a damaged trace is refused, wherever the damage is") {
  const std::string good = write(3, 4, 300).bytes;
  const auto whole = read(good);
  REQUIRE(whole);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < good.size(); i += 11) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    // A bit that the decompressor ignores changes nothing.
    const auto trace = read(bad);
    if (trace) CHECK(contents(*trace) == contents(*whole));
    refused += trace ? 0 : 1;
    CHECK_FALSE(read(good.substr(0, i)));
  }
  CHECK(refused + 20 > good.size() / 11);
  CHECK_FALSE(read(good + "x"));
}

TEST_CASE("a copied trace goes on as if it had never stopped") {
  const std::string good = write(8, 3, 700).bytes;
  const auto trace = read(good);
  REQUIRE(trace);
  CHECK(contents(*trace) == good);
  for (const std::uint64_t tick : {0U, 4U, 998U, 1000U, 1400U, 2799U}) {
    std::string copy;
    PoseTraceWriter writer(trace->header, [&](std::string_view b) { copy += b; });
    copy_records(*trace, tick, writer);
    writer.finish({tick, RunEnd::interrupted, 0, ""});
    const auto part = read(copy);
    REQUIRE(part);
    CHECK(part->frames == tick / 4 + 1);
  }
}
