// SPDX-License-Identifier: MIT
#include "physical/sensors/camera_reading.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <thread>

#include "physical/sensors/sensor_support.h"
#include "sensing/led_colour.h"
#include "support/uses.h"

using namespace stig;

namespace {

SensorScene some_blocks() {
  SensorScene scene;
  for (std::uint32_t i = 0; i < 12; ++i) {
    add_block(scene,
              {{0.18 + 0.08 * (i % 3), 0.07 * (i / 3) - 0.1, 0.0275}, rotation({0, 0, 0.5 * i})},
              i + 1);
  }
  return scene;
}
const Pose kCamera = tilted_camera({0, 0, 0.25}, 0);

CameraReading read(const SensorScene& scene, const CameraNoise& noise = {},
                   const NoiseAddress& address = {}) {
  const CameraView view = paper_view();
  return read_camera(scene, look(SensorIndex(scene), view, kCamera), view, noise, address);
}

/// All numbers of a reading.
std::vector<double> numbers(const CameraReading& r) {
  std::vector<double> out;
  for (const TagReading& t : r.tags) {
    out.insert(out.end(), {double(t.id), t.p_CT.x, t.p_CT.y, t.p_CT.z, t.q_CT.w, t.q_CT.x, t.q_CT.y,
                           t.q_CT.z, t.centre.x, t.centre.y});
    for (const ImagePoint& c : t.corners) out.insert(out.end(), {c.x, c.y});
  }
  for (const LedReading& l : r.leds) out.insert(out.end(), {l.centre.x, l.centre.y, l.y, l.u, l.v});
  return out;
}

CameraNoise all_noise() { return {0.5, 0.1, 0.1, 0.5, 0.5, 5, 0}; }

}  // namespace

TEST_CASE("without noise a reading is the truth, found from pixels") {
  const SensorScene scene = some_blocks();
  const CameraSight sight = look(SensorIndex(scene), paper_view(), kCamera);
  const CameraReading reading = read(scene);
  REQUIRE(reading.tags.size() == sight.tags.size());
  REQUIRE(reading.leds.size() == sight.leds.size());
  REQUIRE(sight.tags.size() > 3);
  CHECK(reading.enabled);
  for (std::size_t i = 0; i < sight.tags.size(); ++i) {
    const SeenTag& seen = sight.tags[i];
    const TagMark& tag = scene.kinds[0].tags[seen.tag];
    const Pose X_CT = inverse(kCamera) * scene.marked[seen.body].X_WB * tag.X_BT;
    CHECK(reading.tags[i].id == tag.id);
    CHECK(length(reading.tags[i].p_CT - X_CT.p) < 1e-7);
    CHECK(angle_of(conjugate(reading.tags[i].q_CT) * X_CT.q) < 1e-5);
    CHECK(reading.tags[i].corners[2].x == seen.corners[2].x);
  }
}

TEST_CASE("a block's colours are classified as themselves") {
  for (std::uint8_t colour = 1; colour <= 4; ++colour) {
    SensorScene scene;
    add_block(scene, {{0.22, 0, 0.0275}, {}}, 1, led_rgb(colour));
    const CameraReading reading = read(scene);
    CHECK(reading.leds.size() >= 4);
    for (const LedReading& l : reading.leds) CHECK(classify_led(l.u, l.v) == colour);
  }
}

TEST_CASE("each kind of noise has the size that it is given") {
  SensorScene scene;
  add_block(scene, {{0.22, 0, 0.0275}, {}}, 1);
  const CameraReading clean = read(scene);
  REQUIRE(!clean.tags.empty());
  const std::size_t tags = clean.tags.size(), leds = clean.leds.size();
  constexpr int kTicks = 3000;
  double pixel = 0, colour = 0, missed_tags = 0, missed_leds = 0, false_tags = 0, false_leds = 0;
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) {
    const NoiseAddress address{1, 2, 3, tick};
    const CameraReading blurred = read(scene, {0.5, 0, 0, 0, 0, 5, 0}, address);
    REQUIRE(blurred.tags.size() == tags);
    const double dx = blurred.tags[0].corners[1].x - clean.tags[0].corners[1].x;
    const double dy = blurred.leds[0].centre.y - clean.leds[0].centre.y;
    const double du = blurred.leds[0].u - clean.leds[0].u;
    pixel += (dx * dx + dy * dy) / 2;
    colour += du * du;
    const CameraReading missing = read(scene, {0, 0.3, 0.2, 0, 0, 0, 0}, address);
    missed_tags += double(tags - missing.tags.size());
    missed_leds += double(leds - missing.leds.size());
    const CameraReading more = read(scene, {0, 0, 0, 0.1, 0.4, 0, 0}, address);
    false_tags += double(more.tags.size() - tags);
    false_leds += double(more.leds.size() - leds);
  }
  CHECK(std::sqrt(pixel / kTicks) == doctest::Approx(0.5).epsilon(0.05));
  CHECK(std::sqrt(colour / kTicks) == doctest::Approx(5).epsilon(0.05));
  CHECK(missed_tags / (kTicks * double(tags)) == doctest::Approx(0.3).epsilon(0.05));
  CHECK(missed_leds / (kTicks * double(leds)) == doctest::Approx(0.2).epsilon(0.05));
  CHECK(false_tags / kTicks == doctest::Approx(0.1).epsilon(0.15));
  CHECK(false_leds / kTicks == doctest::Approx(0.4).epsilon(0.1));
}

TEST_CASE("false tags lie in the image and in reach") {
  const SensorScene nothing;
  int seen = 0;
  for (std::uint64_t tick = 0; tick < 300; ++tick) {
    for (const TagReading& t : read(nothing, {0, 0, 0, 1, 0, 0, 0}, {5, 0, 0, tick}).tags) {
      ++seen;
      CHECK(t.id >= 0);
      CHECK(t.id < 587);
      CHECK(t.p_CT.z > 0.04);
      CHECK(t.p_CT.z < 0.51);
      for (const ImagePoint& c : t.corners) CHECK(inside_image(paper_view().intrinsics, c));
    }
  }
  CHECK(seen > 290);
}

TEST_CASE("errors depend on their address alone") {
  const SensorScene scene = some_blocks();
  const auto at = [&](const NoiseAddress& a) { return numbers(read(scene, all_noise(), a)); };
  CHECK(at({1, 2, 3, 4}) == at({1, 2, 3, 4}));
  CHECK(at({1, 2, 3, 4}) != at({2, 2, 3, 4}));
  CHECK(at({1, 2, 3, 4}) != at({1, 3, 3, 4}));
  CHECK(at({1, 2, 3, 4}) != at({1, 2, 4, 4}));
  CHECK(at({1, 2, 3, 4}) != at({1, 2, 3, 5}));
}

TEST_CASE("robots may look in any number of threads") {
  const SensorScene scene = some_blocks();
  const SensorIndex index(scene);
  const CameraView view = paper_view();
  const auto sense = [&](std::uint32_t robot) {
    const Pose X_WC = tilted_camera({0.02 * robot, 0, 0.25}, 0.1 * robot);
    return numbers(
        read_camera(scene, look(index, view, X_WC), view, all_noise(), {9, robot, 0, 7}));
  };
  std::array<std::vector<double>, 8> alone, together;
  for (std::uint32_t r = 0; r < 8; ++r) alone[r] = sense(r);
  std::vector<std::thread> threads;
  for (std::uint32_t r = 8; r-- > 0;) threads.emplace_back([&, r] { together[r] = sense(r); });
  for (std::thread& t : threads) t.join();
  CHECK(alone == together);
}

TEST_CASE("late readings arrive in order, after empty ones") {
  Late<std::vector<int>> late;
  CHECK(late.pass({1}, 2).empty());
  CHECK(late.pass({2}, 2).empty());
  CHECK(late.pass({3}, 2) == std::vector<int>{1});
  CHECK(late.pass({4}, 2) == std::vector<int>{2});
  Late<std::vector<int>> prompt;
  CHECK(prompt.pass({5}, 0) == std::vector<int>{5});
}
