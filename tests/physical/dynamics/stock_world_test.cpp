// SPDX-License-Identifier: MIT
// World against DART's own step, where that one is sound: few blocks, sliding along an axis.

#include <cmath>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

WorldConfig on_stock(WorldConfig config) {
  config.solver = SolverKind::stock;
  return config;
}

/// Largest distance between the two worlds' bodies after some time, m.
double difference(const WorldConfig& config, double seconds) {
  World own(config);
  World stock(on_stock(config));
  double most = 0;
  while (own.time() < seconds - 1e-9) {
    REQUIRE(own.step().ok);
    REQUIRE(stock.step().ok);
  }
  for (std::uint32_t i = 0; i < own.size(); ++i) {
    const Vec3 apart = own.state(BodyId{i}).X_WB.p - stock.state(BodyId{i}).X_WB.p;
    most = std::max(most, length(apart));
  }
  return most;
}

}  // namespace

TEST_CASE("DART agrees on a spinning body in flight") {
  BodyDef def = solid_body(Shape::box({0.1, 0.2, 0.3}), 1, {0, 0, 8});
  def.velocity = {1, 0, 2};
  def.spin = {3, 2, 1};
  // DART falls by one step's gravity more: g t dt / 2.
  CHECK(difference(single(def), 1) == doctest::Approx(9.8 * 0.005 / 2).epsilon(0.01));
}

TEST_CASE("DART agrees on a block that falls and rests, and on a column") {
  const BlockModel block = without_magnets(paper_block());
  WorldConfig config = scene_settings();
  config.bodies = {block_body(block, {{0, 0, 0.06}, {}})};
  CHECK(difference(config, 1) < 1e-3);
  CHECK(difference(column_scene(block, 3), 1) < 1e-3);
}

TEST_CASE("DART agrees on sliding along an axis") {
  WorldConfig config = scene_settings({0.3, 0.3});
  config.frictions.push_back({kFloorMaterial, kFloorMaterial, 0.3});
  BodyDef def = block_body(without_magnets(paper_block()), {{0, 0, 0.0275 - 1e-5}, {}});
  def.velocity = {0.5, 0, 0};
  config.bodies = {def};
  CHECK(difference(config, 1) < 0.003);  // of 42 mm
}

TEST_CASE("DART agrees that two blocks click") {
  WorldConfig config = pair_scene(paper_block(), 0.01, 0.2);
  config.frictions.push_back({kFloorMaterial, kFloorMaterial, 0.2});
  CHECK(difference(config, 0.5) < 2e-3);
}

TEST_CASE("DART's path refuses forces that are none") {
  World world(on_stock(single(solid_body(Shape::sphere(0.1), 1, {0, 0, 1}))));
  world.push(BodyId{0}, {std::nan(""), 0, 0}, {});
  CHECK_FALSE(world.step().ok);
}

TEST_CASE("DART's path has events, and goes on from a checkpoint") {
  WorldConfig config = on_stock(scene_settings());
  config.arena = 0.5;
  for (int i = 0; i < 3; ++i) {
    config.bodies.push_back(block_body(paper_block(), {{0.001 * i, 0, 0.05 + 0.07 * i}, {}}));
  }
  config.bodies.push_back(block_body(paper_block(), {{0.4, 0, 0.1}, {}}));
  config.bodies.back().velocity = {1, 0, 0};
  World first(config), second(config);
  std::size_t kinds[6] = {};
  const auto step = [&](World& world) {
    REQUIRE(world.step().ok);
    for (const WorldEvent& event : world.events()) ++kinds[static_cast<std::size_t>(event.kind)];
  };
  for (int i = 0; i < 60; ++i) step(first);
  REQUIRE(second.resume(first.checkpoint()));
  for (int i = 0; i < 60; ++i) step(first), step(second);
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    CHECK(length(state(first, i).X_WB.p - state(second, i).X_WB.p) < 1e-4);
  }
  for (const EventKind kind :
       {EventKind::contact_began, EventKind::left_arena, EventKind::snapped}) {
    CHECK(kinds[static_cast<std::size_t>(kind)] > 0);
  }
  CHECK(kinds[static_cast<std::size_t>(EventKind::slept)] == 0);
}

TEST_CASE("DART's path takes bodies that come later, and fixed ones that move") {
  WorldConfig config = on_stock(scene_settings());
  config.bodies = {block_body(without_magnets(paper_block()), {{0, 0, 0.0275}, {}})};
  World world(config);
  run(world, 0.1);
  BodyDef rod = solid_body(Shape::box({0.05, 0.05, 0.05}), 1, {-0.1, 0, 0.0275});
  rod.fixed = true;
  rod.velocity = {0.1, 0, 0};
  REQUIRE(world.add({{rod}, {}}).problem.empty());
  run(world, 1);
  CHECK(state(world, 1).X_WB.p.x == doctest::Approx(0).epsilon(0.001));
  CHECK(state(world, 0).X_WB.p.x == doctest::Approx(0.0525).epsilon(0.05));
}

TEST_CASE("DART's path refuses joints") {
  WorldConfig config = on_stock(scene_settings());
  config.bodies = {solid_body(Shape::sphere(0.1), 1, {0, 0, 1})};
  config.joints.resize(1);
  REQUIRE(problems_of(config).size() == 1);
  CHECK(problems_of(config)[0] == "solver 'stock' knows no joints");
}
