// SPDX-License-Identifier: MIT
// Blocks in contact: sliding, stacks, walls, and magnets that hold.
#include <cmath>
#include <tuple>

#include "physical/support.h"

using namespace stig;

TEST_CASE("a sliding block stops where friction says, in every direction") {
  const BlockModel block = without_magnets(paper_block());
  for (const double angle : {0.0, 20.0, 45.0, 70.0, 90.0, 225.0}) {
    CAPTURE(angle);
    WorldConfig config = scene_settings({0.3, 0.3});
    const double a = angle * 3.14159265358979 / 180;
    BodyDef def = block_body(block, {{0, 0, 0.0275 - 1e-5}, {}});
    def.velocity = Vec3{std::cos(a), std::sin(a), 0} * 0.5;
    config.bodies = {def};
    World world(config);
    run(world, 1);
    const Vec3 way = state(world, 0).X_WB.p - def.X_WB.p;
    const double theory = 0.25 / (2 * 0.3 * 9.8);
    CHECK(std::hypot(way.x, way.y) == doctest::Approx(theory).epsilon(0.04));
    CHECK(std::abs(way.x * std::sin(a) - way.y * std::cos(a)) < 0.001);
  }
}

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
  CHECK(drift(world, config) < 50e-6);
  for (std::uint32_t i = 0; i < 5; ++i) CHECK(length(state(world, i).velocity) < 1e-4);
}

TEST_CASE("a pyramid with magnets moves less than 0.1 mm in ten minutes, soon asleep") {
  const WorldConfig config = pyramid_scene(paper_block());
  REQUIRE(config.bodies.size() == 15);
  World world(config);
  run(world, 1);
  CHECK(world.awake_count() == 0);
  run(world, 599);
  CHECK(drift(world, config) < 1e-4);
}

TEST_CASE("a pyramid with magnets that may not sleep stays too") {
  WorldConfig config = pyramid_scene(paper_block());
  config.sleep.enabled = false;
  World world(config);
  run(world, 10);
  CHECK(drift(world, config) < 1e-4);
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
    CHECK(drift(world, config) < most);
  }
}

TEST_CASE("two blocks 10 mm apart click together") {
  for (const double friction : {0.05, 0.2, 0.5}) {
    CAPTURE(friction);
    World world(pair_scene(paper_block(), 0.010, friction));
    const auto gap = [&] { return state(world, 1).X_WB.p.x - state(world, 0).X_WB.p.x - 0.055; };
    while (gap() > 1e-4 && world.time() < 0.25) REQUIRE(world.step().ok);
    CHECK(world.time() < 0.25);
    run(world, 1);
    CHECK(std::abs(gap()) < 1e-4);
    CHECK(std::abs(state(world, 1).X_WB.p.y - state(world, 0).X_WB.p.y) < 3e-4);
    CHECK(world.awake_count() == 0);
  }
}

TEST_CASE("magnets at the strength of real ones click too, where it is smooth") {
  BlockModel block = paper_block();
  block.magnet_field = 0.117 / kMomentPerField;
  for (const double friction : {0.05, 0.18}) {
    CAPTURE(friction);
    World world(pair_scene(block, 0.010, friction));
    run(world, 1);
    CHECK(state(world, 1).X_WB.p.x - state(world, 0).X_WB.p.x - 0.055 < 1e-4);
  }
}

TEST_CASE("a block held from above by magnets hangs until it is pulled off") {
  // Four pairs of the paper's magnets 10 mm apart hold 9.5 N; the block weighs 1.08 N.
  for (const auto& [load, holds] : {std::pair(7.5, true), std::pair(9.4, false)}) {
    CAPTURE(load);
    WorldConfig config = scene_settings();
    config.floor = false;
    config.bodies = {block_body(paper_block(), {{0, 0, 1}, {}}),
                     block_body(paper_block(), {{0, 0, 1 - 0.055 + 1e-5}, {}})};
    config.bodies[0].fixed = true;
    World world(config);
    for (int i = 0; i < 200; ++i) {
      const double part = std::min(1.0, i / 100.0);
      world.push(BodyId{1}, {0, 0, -load * part}, {});
      REQUIRE(world.step().ok);
    }
    CHECK((state(world, 1).X_WB.p.z > 0.94) == holds);
  }
}
