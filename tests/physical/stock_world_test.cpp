// SPDX-License-Identifier: MIT
// World against DART's own step, where that one is sound: few blocks, sliding along an axis.
#if STIG_WITH_DART

#include "physical/stock_world.h"

#include <cmath>

#include "physical/support.h"

using namespace stig;

namespace {

/// Largest distance between the two worlds' bodies after some time, m.
double difference(const WorldConfig& config, double seconds) {
  World own(config);
  StockWorld stock(config);
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
  StockWorld world(single(solid_body(Shape::sphere(0.1), 1, {0, 0, 1})));
  world.push(BodyId{0}, {std::nan(""), 0, 0}, {});
  CHECK_FALSE(world.step().ok);
}

#endif  // STIG_WITH_DART
