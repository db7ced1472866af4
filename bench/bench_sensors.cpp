// SPDX-License-Identifier: MIT
// What sensing costs a control tick: four robots, each with a camera and 16 rangefinders, about
// a pyramid of 85 blocks with all their LEDs lit; the parts of it; and one camera before ever
// more blocks, of which it sees more and more, or always the same.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "physical/sensors/camera_reading.h"
#include "physical/sensors/radio_medium.h"
#include "physical/sensors/range_sensor.h"
#include "support/uses.h"

namespace stig::bench {
namespace {

constexpr double kSide = 0.055;
constexpr double kDegree = std::numbers::pi / 180;
constexpr Rgb kColour{74, 255, 27};

CameraView view_to(double far) {
  CameraIntrinsics c;
  c.fx = c.fy = 883.961;
  c.cx = 319.5;
  c.cy = 179.5;
  const auto view = make_view(c, 0.05, far);
  if (!view) std::abort();
  return *view;
}

SensorScene empty_scene() {
  FaceMarks marks;
  marks.tag_widest = marks.led_widest = 75 * kDegree;
  SensorScene scene;
  scene.kinds = {cube_marks(marks)};
  scene.shapes = {sight_box({kSide, kSide, kSide}), sight_box({0.12, 0.09, 0.1}),
                  sight_box({0.06, 0.09, 0.29}), sight_cylinder(0.016, 0.014),
                  sight_cylinder(0.01, 0.0235)};
  return scene;
}

void add_block(SensorScene& scene, const Vec3& p) {
  const auto owner = static_cast<std::uint32_t>(scene.marked.size() + 1);
  scene.obstacles.push_back({0, owner, {p, {}}});
  scene.marked.push_back({0, owner, {p, {}}, std::vector<Rgb>(24, kColour)});
}

/// Layers of 7 x 7, 5 x 5, 3 x 3 and one block, and one carried: 85.
SensorScene pyramid() {
  SensorScene scene = empty_scene();
  for (int layer = 0; layer < 4; ++layer) {
    for (int x = layer - 3; x <= 3 - layer; ++x) {
      for (int y = layer - 3; y <= 3 - layer; ++y) {
        add_block(scene, {x * kSide, y * kSide, (layer + 0.5) * kSide});
      }
    }
  }
  add_block(scene, {-0.45, 0, 0.0275});
  return scene;
}

/// Ahead along x turned by `yaw`, 45 degrees down.
Pose camera_at(const Vec3& p_W, double yaw) {
  const Quat level{0.5, -0.5, 0.5, -0.5};
  return {p_W, rotation({0, 0, yaw}) * level * rotation({-45 * kDegree, 0, 0})};
}

struct Robot {
  Pose X_WR;
  Pose X_WC;
  std::uint32_t owner = 0;
};

/// Fifteen bodies each, as many as the paper's robot has, facing the pyramid.
std::vector<Robot> add_robots(SensorScene& scene) {
  std::vector<Robot> robots;
  for (int i = 0; i < 4; ++i) {
    const double yaw = i * 90 * kDegree;
    const Pose X_WR{rotate(rotation({0, 0, yaw}), {-0.45, 0, 0}), rotation({0, 0, yaw})};
    const auto owner = static_cast<std::uint32_t>(1000 + i);
    for (int b = 0; b < 15; ++b) {
      const auto shape = static_cast<std::uint32_t>(b < 3 ? 1 : b < 7 ? 3 : b < 11 ? 4 : 2);
      const Vec3 at{-0.05 - 0.01 * (b % 3), 0.02 * (b % 4) - 0.03, 0.03 + 0.02 * (b % 5)};
      scene.obstacles.push_back({shape, owner, X_WR * Pose{at, {}}});
    }
    robots.push_back({X_WR, camera_at(X_WR * Vec3{0.05, 0, 0.25}, yaw), owner});
  }
  return robots;
}

std::vector<RangeDevice> rangefinders() {
  std::vector<RangeDevice> out;
  for (int i = 0; i < 16; ++i) {
    const double angle = i * 22.5 * kDegree;
    out.push_back({"",
                   0,
                   {0.04 * std::cos(angle), 0.04 * std::sin(angle), 0.046},
                   {std::cos(angle), std::sin(angle), 0},
                   0.2,
                   RangeDevice::Calibration::power,
                   {5432.4, 87.70362, 0}});
  }
  return out;
}

void count(benchmark::State& state, const CameraSight& sight) {
  state.counters["tags"] = double(sight.tags.size());
  state.counters["leds"] = double(sight.leds.size());
}

void index_of_the_scene(benchmark::State& state) {
  SensorScene scene = pyramid();
  add_robots(scene);
  for (auto _ : state) benchmark::DoNotOptimize(SensorIndex(scene).axes.data());
}
BENCHMARK(index_of_the_scene)->Unit(benchmark::kMicrosecond);

void one_camera(benchmark::State& state) {
  SensorScene scene = pyramid();
  const auto robots = add_robots(scene);
  const SensorIndex index(scene);
  const CameraView view = view_to(0.5);
  CameraSight sight;
  for (auto _ : state) sight = look(index, view, robots[0].X_WC);
  count(state, sight);
}
BENCHMARK(one_camera)->Unit(benchmark::kMicrosecond);

void readings_of_one_camera(benchmark::State& state) {
  SensorScene scene = pyramid();
  const auto robots = add_robots(scene);
  const CameraView view = view_to(0.5);
  const CameraSight sight = look(SensorIndex(scene), view, robots[0].X_WC);
  const CameraNoise noise{double(state.range(0)) * 0.5, 0, 0, 0, 0, 0, 0};
  for (auto _ : state) {
    benchmark::DoNotOptimize(read_camera(scene, sight, view, noise, {}).tags.data());
  }
  count(state, sight);
}
BENCHMARK(readings_of_one_camera)
    ->ArgName("half_pixels")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);

void tick_of_four_robots(benchmark::State& state) {
  SensorScene scene = pyramid();
  const auto robots = add_robots(scene);
  const auto devices = rangefinders();
  const CameraView view = view_to(0.5);
  const CameraNoise noise{0.5, 0.05, 0.05, 0.01, 0.01, 3, 0};
  std::uint64_t tick = 0;
  CameraSight seen;
  for (auto _ : state) {
    const SensorIndex index(scene);
    seen = {};
    ++tick;
    for (const Robot& robot : robots) {
      const CameraSight sight = look(index, view, robot.X_WC);
      benchmark::DoNotOptimize(
          read_camera(scene, sight, view, noise, {1, robot.owner, 0, tick}).tags.data());
      seen.tags.insert(seen.tags.end(), sight.tags.begin(), sight.tags.end());
      seen.leds.insert(seen.leds.end(), sight.leds.begin(), sight.leds.end());
      for (const RangeDevice& d : devices) {
        benchmark::DoNotOptimize(read_range(index, d, robot.X_WR, robot.owner, {}, {}));
      }
    }
  }
  count(state, seen);
}
BENCHMARK(tick_of_four_robots)->Unit(benchmark::kMicrosecond);

/// Blocks 9 cm apart in a square field before the camera.
SensorScene field(int blocks) {
  SensorScene scene = empty_scene();
  for (int i = 0; i < blocks; ++i) {
    add_block(scene, {0.09 * (i % 32), 0.09 * (i / 32 - blocks / 64.0), 0.0275});
  }
  return scene;
}

/// High above them it sees the more, the more there are: time by LEDs seen should stay.
void more_in_view(benchmark::State& state) {
  SensorScene scene = empty_scene();
  const int side = static_cast<int>(state.range(0));
  for (int i = 0; i < side * side; ++i) {
    add_block(scene, {0.08 * (i % side), 0.08 * (i / side - side / 2.0), 0.0275});
  }
  const double high = 0.3 * side;
  const CameraView view = view_to(4 * high);
  const Pose X_WC = camera_at({0.04 * side - high, 0, high}, 0);
  const SensorIndex index(scene);
  CameraSight sight;
  for (auto _ : state) {
    sight = look(index, view, X_WC);
    benchmark::DoNotOptimize(read_camera(scene, sight, view, {}, {}).tags.data());
  }
  count(state, sight);
  state.counters["each"] = benchmark::Counter(
      double(sight.tags.size() + sight.leds.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(more_in_view)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);

/// The same view, whatever stands elsewhere.
void more_elsewhere(benchmark::State& state) {
  const SensorScene scene = field(static_cast<int>(state.range(0)));
  const SensorIndex index(scene);
  const CameraView view = view_to(0.5);
  const Pose X_WC = camera_at({0.2, 0, 0.25}, 0);
  CameraSight sight;
  for (auto _ : state) sight = look(index, view, X_WC);
  count(state, sight);
}
BENCHMARK(more_elsewhere)->Arg(256)->Arg(1024)->Arg(4096)->Unit(benchmark::kMicrosecond);

/// The blocks of a field, six radios each, of which every tenth block sends.
void radios(benchmark::State& state) {
  std::vector<Radio> all;
  std::vector<std::vector<Message>> sends;
  for (int i = 0; i < state.range(0); ++i) {
    for (int f = 0; f < 6; ++f) {
      const double along = f % 2 == 0 ? 0.0225 : -0.0225;
      const Vec3 at{f / 2 == 0 ? along : 0, f / 2 == 1 ? along : 0, f / 2 == 2 ? along : 0};
      all.push_back({Vec3{kSide * (i % 32), kSide * (i / 32), 0.0275} + at});
      sends.push_back(i % 10 == 0 ? std::vector<Message>{"4"} : std::vector<Message>{});
    }
  }
  for (auto _ : state) benchmark::DoNotOptimize(carry(all, sends).data());
}
BENCHMARK(radios)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stig::bench
