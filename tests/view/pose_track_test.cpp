// SPDX-License-Identifier: MIT
// Tracks: few moments are kept, and interpolation between them is as near as is promised.
#include "view/pose_track.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace stig {
namespace {

TraceState state_at(double x, double angle) {
  BodyState state;
  state.X_WB.p = {x, 0, 0};
  state.X_WB.q = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
  return trace_state(state);
}

/// How far the states are from what the kept ones give, in m and in parts of the quaternion.
std::pair<double, double> worst_of(const std::vector<TrackKey>& all,
                                   const std::vector<TrackKey>& kept) {
  double way = 0, turn = 0;
  for (const TrackKey& key : all) {
    auto next = std::find_if(kept.begin(), kept.end(),
                             [&](const TrackKey& k) { return k.tick >= key.tick; });
    REQUIRE(next != kept.end());
    const auto before = next == kept.begin() ? next : next - 1;
    const auto span = static_cast<double>(next->tick - before->tick);
    const double share = span > 0 ? static_cast<double>(key.tick - before->tick) / span : 0;
    const auto mix = [&](std::int64_t a, std::int64_t b) {
      return static_cast<double>(a) + share * static_cast<double>(b - a);
    };
    const double x = mix(before->state.place[0], next->state.place[0]);
    way = std::max(way, std::abs(x - static_cast<double>(key.state.place[0])) * kPlaceQuantum);
    const double w = mix(before->state.turn[0], next->state.turn[0]);
    const double z = mix(before->state.turn[3], next->state.turn[3]);
    const double is = static_cast<double>(key.state.turn[3]) * kTurnQuantum;
    turn = std::max(turn, std::abs(z / std::hypot(w, z) - is));
  }
  return {way, turn};
}

std::vector<TrackKey> kept_of(const std::vector<TrackKey>& all) {
  PoseTrack track;
  for (const TrackKey& key : all) track.add(key);
  return track.finish();
}

TEST_CASE("a body at rest takes its first and its last moment") {
  std::vector<TrackKey> all;
  for (std::uint64_t i = 0; i <= 1000; ++i) all.push_back({i * 4, state_at(0.5, 0.3)});
  const auto kept = kept_of(all);
  REQUIRE(kept.size() == 2);
  CHECK(kept.front().tick == 0);
  CHECK(kept.back().tick == 4000);
}

TEST_CASE("steady motion takes few moments, and the beginning of motion is one of them") {
  std::vector<TrackKey> all;
  for (std::uint64_t i = 0; i <= 400; ++i) {
    const double moved = i < 200 ? 0 : static_cast<double>(i - 200) * 1e-3;
    all.push_back({i * 4, state_at(moved, 0)});
  }
  const auto kept = kept_of(all);
  CHECK(kept.size() <= 6);
  CHECK(std::any_of(kept.begin(), kept.end(), [](const TrackKey& k) { return k.tick == 800; }));
  CHECK(worst_of(all, kept).first < 1.01e-4);
}

TEST_CASE("what turns and swings stays within the tolerance") {
  std::vector<TrackKey> all;
  for (std::uint64_t i = 0; i <= 2000; ++i) {
    const double t = static_cast<double>(i) * 0.02;
    all.push_back({i * 4, state_at(0.02 * std::sin(t), 1.5 * std::sin(0.7 * t))});
  }
  const auto kept = kept_of(all);
  CHECK(kept.size() < all.size() / 4);
  const auto [way, turn] = worst_of(all, kept);
  CHECK(way < 1.01e-4);
  CHECK(turn < 1.6e-3);
}

TEST_CASE("what comes or leaves does so at its very moment") {
  std::vector<TrackKey> all;
  for (std::uint64_t i = 0; i <= 100; ++i) {
    TraceState state = state_at(static_cast<double>(i) * 1e-3, 0);
    state.left = i < 30 || i > 60;
    all.push_back({i, state});
  }
  const auto kept = kept_of(all);
  for (const std::uint64_t tick : {29, 30, 60, 61}) {
    CAPTURE(tick);
    CHECK(std::any_of(kept.begin(), kept.end(), [&](const TrackKey& k) { return k.tick == tick; }));
  }
}

}  // namespace
}  // namespace stig
