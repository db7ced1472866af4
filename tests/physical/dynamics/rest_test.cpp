// SPDX-License-Identifier: MIT
// Blocks in contact: slopes, stacks, walls.
#include <cmath>
#include <tuple>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

TEST_CASE("a block rests on a slope that friction holds, and slides on a steeper one") {
  // The slope: gravity is along z, so a fixed plank is turned.
  for (const auto& [degrees, holds] : {std::pair(10.0, true), std::pair(25.0, false)}) {
    CAPTURE(degrees);
    const Quat q = normalised(rotation({0, degrees * 3.14159265358979 / 180, 0}));
    WorldConfig config = scene_settings({0.3, 0.3});
    config.floor = false;
    BodyDef plank = solid_body(Shape::box({3, 1, 0.1}), 1);
    plank.X_WB.q = q;
    plank.fixed = true;
    const Vec3 up = matrix(q).z;
    config.bodies = {plank, block_body(without_magnets(paper_block()), {up * 0.0775, q})};
    World world(config);
    run(world, 1);
    const double way = length(state(world, 1).X_WB.p - up * 0.0775);
    const double a = degrees * 3.14159265358979 / 180;
    const double theory = 0.5 * 9.8 * (std::sin(a) - 0.3 * std::cos(a));
    if (holds) CHECK(way < 1e-4);
    if (!holds) CHECK(way == doctest::Approx(theory).epsilon(0.02));
  }
}

TEST_CASE("a stack of five rests, awake") {
  WorldConfig config = column_scene(without_magnets(paper_block()), 5);
  config.sleep.enabled = false;
  World world(config);
  run(world, 5);
  CHECK(largest_drift(world, config) < 50e-6);
  for (std::uint32_t i = 0; i < 5; ++i) CHECK(length(state(world, i).velocity) < 1e-4);
}

TEST_CASE("a pyramid with magnets that may not sleep stays too") {
  WorldConfig config = pyramid_scene(paper_block());
  config.sleep.enabled = false;
  World world(config);
  run(world, 10);
  CHECK(largest_drift(world, config) < 1e-4);
}

TEST_CASE("a wall of a hundred stands") {
  // Length, height, and how far its blocks may have moved.
  const std::tuple<int, int, double> walls[] = {{20, 5, 5e-5}, {10, 10, 1e-3}};
  for (const auto& [wide, high, most] : walls) {
    CAPTURE(high);
    WorldConfig config = wall_scene(without_magnets(paper_block()), wide, high);
    config.sleep.enabled = false;
    World world(config);
    run(world, 3);
    CHECK(largest_drift(world, config) < most);
  }
}
