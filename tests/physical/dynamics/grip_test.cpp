// SPDX-License-Identifier: MIT
// Bodies that rub with more or less than the friction of their materials.
#include <cmath>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

/// A block that slides along the floor at 1 m/s.
WorldConfig sliding_block() {
  WorldConfig config = scene_settings();
  config.bodies = {block_body(without_magnets(paper_block()), {{0, 0, 0.0275}, {}})};
  config.bodies[0].velocity = {1, 0, 0};
  return config;
}

}  // namespace

TEST_CASE("a sliding block stops after v² / 2μg, with μ as many times as its grip says") {
  for (const double factor : {0.5, 1.0, 2.0}) {
    CAPTURE(factor);
    World world(sliding_block());
    world.set_grip(BodyId{0}, factor);
    run(world, 2);
    // Block on floor: 0.4.
    CHECK(state(world, 0).X_WB.p.x == doctest::Approx(1 / (2 * 0.4 * factor * 9.8)).epsilon(0.02));
  }
}

TEST_CASE("a grip is part of checkpoints and hashes, and of none in worlds where nobody set one") {
  World plain(sliding_block()), slippery(sliding_block());
  run(plain, 0.1), run(slippery, 0.1);
  const std::string before = plain.checkpoint();
  slippery.set_grip(BodyId{0}, 0.5);
  CHECK(slippery.hash() != plain.hash());
  const std::string bytes = slippery.checkpoint();
  CHECK(bytes.size() > before.size());

  World resumed(sliding_block());
  REQUIRE(resumed.resume(bytes));
  run(slippery, 1), run(resumed, 1), run(plain, 1);
  CHECK(resumed.checkpoint() == slippery.checkpoint());
  CHECK(state(slippery, 0).X_WB.p.x > state(plain, 0).X_WB.p.x + 0.03);
  // What was changed does not outlive a checkpoint from before.
  REQUIRE(resumed.resume(before));
  CHECK(resumed.checkpoint() == before);
  slippery.set_grip(BodyId{0}, 1);
  CHECK(slippery.checkpoint().size() < bytes.size());
}

TEST_CASE("damaged grips bring nothing back") {
  World world(sliding_block());
  world.set_grip(BodyId{0}, 0.5);
  const std::string bytes = world.checkpoint();
  const auto bad = [&](std::size_t from_end, char byte) {
    std::string out = bytes;
    out[out.size() - from_end] = byte;
    World fresh(sliding_block());
    return !fresh.resume(out);
  };
  // The last eight bytes are the factor, the four before them the body, and before these a count.
  CHECK(bad(1, '\xbf'));
  CHECK(bad(1, '\x7f') == false);
  CHECK(bad(12, '\1'));
  CHECK(bad(20, '\2'));
  World fresh(sliding_block());
  CHECK_FALSE(fresh.resume(bytes.substr(0, bytes.size() - 1)));
  CHECK_FALSE(fresh.resume(bytes + '\0'));
}

TEST_CASE("what lies asleep on a fixed slope slides once the slope has lost its grip") {
  WorldConfig config = scene_settings();
  config.floor = false;
  const double slope = 0.1;  // rad; tan is half of the friction between blocks
  BodyDef plank = solid_body(Shape::box({1, 0.2, 0.02}), 1);
  plank.fixed = true;
  plank.material = kBlockMaterial;
  plank.X_WB.q = rotation({0, slope, 0});
  BodyDef block = block_body(without_magnets(paper_block()), {});
  block.X_WB = plank.X_WB * Pose{{0, 0, 0.01 + 0.0275}, {}};
  config.bodies = {plank, block};
  World world(config);
  run(world, 2);
  REQUIRE_FALSE(state(world, 1).awake);
  const double at = state(world, 1).X_WB.p.x;
  world.set_grip(BodyId{0}, 0.1);
  run(world, 0.5);
  // g (sin − 0.02 cos) t² / 2 along the slope.
  const double way = 9.8 * (std::sin(slope) - 0.02 * std::cos(slope)) * 0.125;
  CHECK(state(world, 1).X_WB.p.x - at == doctest::Approx(way * std::cos(slope)).epsilon(0.03));
}
