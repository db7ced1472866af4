// SPDX-License-Identifier: MIT
// Sleep, events, determinism, checkpoints, and what is refused.
#include "physical/dynamics/world.h"

#include <limits>
#include <thread>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A scene of some of everything: blocks that fall upon each other with magnets.
WorldConfig lively_scene() { return drop_scene(paper_block(), 12); }

}  // namespace

TEST_CASE("a falling block begins a contact, then sleeps; a push wakes it") {
  WorldConfig config = scene_settings();
  config.bodies = {block_body(without_magnets(paper_block()), {{0, 0, 0.1}, {}})};
  World world(config);
  std::size_t began = 0, slept = 0;
  while (world.time() < 1) {
    REQUIRE(world.step().ok);
    began += count(world, EventKind::contact_began);
    slept += count(world, EventKind::slept);
  }
  CHECK(began == 1);
  CHECK(slept == 1);
  CHECK(world.awake_count() == 0);
  world.push(BodyId{0}, {0, 0, 0.5}, {});
  REQUIRE(world.step().ok);
  CHECK(count(world, EventKind::woke) == 1);
  CHECK(world.awake_count() == 1);
}

TEST_CASE("a block that falls onto a sleeping column wakes it") {
  WorldConfig config = column_scene(without_magnets(paper_block()), 3);
  BodyDef late = block_body(without_magnets(paper_block()), {{0, 0, 3}, {}});
  config.bodies.push_back(late);
  World world(config);
  run(world, 0.6);
  CHECK(world.awake_count() == 1);
  std::size_t woke = 0;
  for (int i = 0; i < 60; ++i) {
    REQUIRE(world.step().ok);
    woke += count(world, EventKind::woke);
  }
  CHECK(woke == 3);
}

TEST_CASE("what loses its support falls") {
  WorldConfig config = scene_settings();
  const BlockModel block = without_magnets(paper_block());
  BodyDef shelf = solid_body(Shape::box({0.2, 0.2, 0.02}), 1);
  shelf.X_WB.p = {0, 0, 0.5};
  shelf.fixed = true;
  config.bodies = {shelf, block_body(block, {{0, 0, 0.5375 - 1e-5}, {}})};
  World world(config);
  run(world, 1);
  CHECK(world.awake_count() == 0);
  world.set_velocity(BodyId{0}, {0, 0, -0.2}, {});
  run(world, 2);
  CHECK(state(world, 1).X_WB.p.z < 0.3);
}

TEST_CASE("a magnet that moves by wakes a sleeper") {
  WorldConfig config = scene_settings();
  config.bodies = {block_body(paper_block(), {{0, 0, 0.0275}, {}}),
                   block_body(paper_block(), {{0.2, 0, 0.0285}, {}})};
  config.bodies[1].fixed = true;
  World world(config);
  run(world, 1);
  REQUIRE(world.awake_count() == 0);
  world.set_velocity(BodyId{1}, {-0.1, 0, 0}, {});
  bool woke = false;
  double nearest = 1;
  for (int i = 0; i < 400 && !woke; ++i) {
    REQUIRE(world.step().ok);
    woke = state(world, 0).awake;
    nearest = state(world, 1).X_WB.p.x - 0.055;
  }
  CHECK(woke);
  CHECK(nearest > 0.005);
}

TEST_CASE("bodies that leave the arena are reported, and the rest goes on") {
  WorldConfig config = scene_settings();
  config.arena = 1;
  config.floor = false;
  config.bodies = {solid_body(Shape::sphere(0.05), 1), solid_body(Shape::sphere(0.05), 1)};
  config.bodies[1].X_WB.p = {0, 0.5, 0};
  config.bodies[1].velocity = {0, 0, 4};
  World world(config);
  std::size_t left = 0;
  for (int i = 0; i < 120; ++i) {
    REQUIRE(world.step().ok);
    left += count(world, EventKind::left_arena);
  }
  CHECK(left == 1);
  CHECK(state(world, 0).left);
  CHECK_FALSE(state(world, 1).left);
}

TEST_CASE("same bytes in two threads and after resuming at any tick") {
  const WorldConfig config = lively_scene();
  const int steps = 300;
  std::vector<std::uint64_t> hashes;
  std::vector<std::string> checkpoints;
  World first(config);
  for (int i = 0; i < steps; ++i) {
    REQUIRE(first.step().ok);
    hashes.push_back(first.hash());
    checkpoints.push_back(first.checkpoint());
  }
  std::vector<std::uint64_t> ends(2);
  std::vector<std::thread> threads;
  for (std::uint64_t& end : ends) {
    threads.emplace_back([&config, &end] {
      World world(config);
      for (int i = 0; i < steps; ++i) static_cast<void>(world.step());
      end = world.hash();
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(ends[0] == hashes.back());
  CHECK(ends[1] == hashes.back());
  for (const int at : {0, 17, 100, 233, 298}) {
    CAPTURE(at);
    World world(config);
    REQUIRE(world.resume(checkpoints[static_cast<std::size_t>(at)]));
    CHECK(world.hash() == hashes[static_cast<std::size_t>(at)]);
    for (int i = at + 1; i < steps; ++i) {
      REQUIRE(world.step().ok);
      REQUIRE(world.hash() == hashes[static_cast<std::size_t>(i)]);
    }
  }
}

TEST_CASE("what is no checkpoint of this configuration is refused") {
  WorldConfig config = lively_scene();
  World world(config);
  run(world, 0.3);
  const std::string good = world.checkpoint();
  config.gravity = 1;
  World other(config);
  CHECK_FALSE(other.resume(good));
  const std::uint64_t hash = world.hash();
  CHECK_FALSE(world.resume(""));
  CHECK_FALSE(world.resume(good.substr(0, good.size() - 1)));
  CHECK_FALSE(world.resume(good + "x"));
  for (std::size_t i = 0; i < good.size(); i += 97) {
    CHECK_FALSE(world.resume(good.substr(0, i)));
  }
  std::string huge = good;
  huge.replace(24, 8, "\xff\xff\xff\xff\xff\xff\xff\xff");  // the first body's place: a NaN
  CHECK_FALSE(world.resume(huge));
  CHECK(world.hash() == hash);
}

TEST_CASE("physics that diverges names the body") {
  WorldConfig config = scene_settings();
  config.bodies = {solid_body(Shape::sphere(0.05), 1), solid_body(Shape::sphere(0.05), 1)};
  config.bodies[0].X_WB.p = {0, 0, 0.05};
  config.bodies[1].X_WB.p = {1, 0, 0.05};
  for (const double force : {1e9, kNaN}) {
    World world(config);
    world.push(BodyId{1}, {force, 0, 0}, {});
    const StepResult result = world.step();
    CHECK_FALSE(result.ok);
    CHECK(result.body == BodyId{1});
    CHECK(state(world, 1).X_WB.p == Vec3{1, 0, 0.05});
    CHECK(world.tick() == 0);
  }
}

TEST_CASE("configurations that make no world are refused, with the body named") {
  const auto complaint = [](auto change) {
    WorldConfig config = pair_scene(paper_block(), 0.01, 0.2);
    change(config);
    const auto problems = problems_of(config);
    return problems.empty() ? std::string() : problems[0];
  };
  CHECK(complaint([](WorldConfig&) {}) == "");
  CHECK(complaint([](auto& c) { c.bodies[1].mass = 0; }) ==
        "body 1 has a mass that is not positive");
  CHECK(complaint([](auto& c) { c.bodies[1].mass = -1; }) ==
        "body 1 has a mass that is not positive");
  CHECK(complaint([](auto& c) { c.bodies[0].X_WB.p.x = kNaN; }) ==
        "body 0 has a pose that is none");
  CHECK(complaint([](auto& c) { c.bodies[0].X_WB.q.w = 2; }) == "body 0 has a pose that is none");
  CHECK(complaint([](auto& c) { c.bodies[0].X_WB.p.x = 1e6; }) == "body 0 is outside of the arena");
  CHECK(complaint([](auto& c) { c.bodies[0].X_WB.p.z = 0; }) == "body 0 is in the floor");
  CHECK(complaint([](auto& c) { c.bodies[0].shape.half.y = 0; }) == "body 0 has no extent");
  CHECK(complaint([](auto& c) {
          c.bodies[0].inertia = {1, 1, 5};
        }) == "body 0 has moments of inertia that no body has");
  CHECK(complaint([](auto& c) { c.bodies[1].velocity.x = kNaN; }) == "body 1 is too fast");
  CHECK(complaint([](auto& c) { c.bodies[1].magnets[0].moment = kNaN; }) ==
        "body 1 has a magnet that is none");
  CHECK(complaint([](auto& c) { c.bodies[0].X_WB.p.x += 0.02; }) == "bodies 0 and 1 overlap");
  CHECK(complaint([](auto& c) { c.bodies[0].shape = Shape::sphere(9.9); }) ==
        "the largest body is more than 200 times the smallest");
  CHECK(complaint([](auto& c) { c.step = 1; }) == "step must be at least 1e-06 and at most 0.02");
  CHECK(complaint([](auto& c) { c.magnets = MagnetModel::integrated; }) ==
        "integrated magnets need a step of at most 1 ms");
  CHECK(complaint([](auto& c) { c.bearing_damping = -1; }) ==
        "magnets.bearing_damping must be at least 0 and at most 1");
  CHECK(complaint([](auto& c) { c.snap.force = 0; }) ==
        "magnets.snap_force must be above 0 and at most 10000");
  CHECK(complaint([](auto& c) { c.bodies[0].magnets[3].inertia = 0; }) ==
        "body 0 has a magnet that is none");
  CHECK(complaint([](auto& c) { c.bodies[0].magnets[3].active = kNaN; }) ==
        "body 0 has a magnet that is none");
  CHECK(complaint([](auto& c) { c.friction = -1; }) ==
        "friction.default must be at least 0 and at most 10");
  CHECK(complaint([](auto& c) { c.bodies.resize(100'000, c.bodies[0]); }) ==
        "there may be at most 20000 bodies");
}
