// SPDX-License-Identifier: MIT
// Fast bodies, and bodies that pass each other closely.
#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

namespace {

WorldConfig weightless(std::vector<BodyDef> bodies) {
  WorldConfig config;
  config.gravity = 0;
  config.floor = false;
  config.bodies = std::move(bodies);
  return config;
}

BodyDef cube(const Vec3& place, const Vec3& velocity = {}) {
  BodyDef def = solid_body(Shape::box({0.055, 0.055, 0.055}), 0.11, place);
  def.velocity = velocity;
  return def;
}

}  // namespace

TEST_CASE("a block that passes over another at 10 m/s with 1 mm clearance keeps its speed") {
  for (const double speed : {0.1, 1.0, 10.0, 50.0}) {
    for (int at = 0; at < 7; ++at) {  // where in a step it comes over the edge
      World world(weightless({cube({-0.2 - 0.007 * at, 0, 0.056}, {speed, 0, 0}), cube({})}));
      run(world, std::ceil(0.5 / speed / 0.005) * 0.005);
      CHECK(state(world, 0).velocity == Vec3{speed, 0, 0});
      CHECK(state(world, 1).velocity == Vec3{});
    }
  }
}

TEST_CASE("a fast block does not go through another, nor through the floor") {
  for (const double speed : {5.0, 20.0, 90.0}) {
    World world(weightless({cube({-1.003, 0, 0}, {speed, 0, 0}), cube({})}));
    run(world, 0.5);
    CHECK(state(world, 0).X_WB.p.x < state(world, 1).X_WB.p.x);
    CHECK(state(world, 1).velocity.x == doctest::Approx(speed / 2).epsilon(0.01));
    const double momentum = state(world, 0).velocity.x + state(world, 1).velocity.x;
    CHECK(momentum == doctest::Approx(speed));
    WorldConfig fall = scene_settings();
    fall.bodies = {cube({0, 0, 1}, {0, 0, -speed})};
    World below(fall);
    while (below.time() < 1) {
      REQUIRE(below.step().ok);
      CHECK(state(below, 0).X_WB.p.z > 0.027);
    }
  }
}

TEST_CASE("a block that comes down askew lands on the top face that it reaches") {
  // Ahead by 20 mm and above by 5 mm, it is over the edge before it is down.
  World world(weightless({cube({-0.075, 0, 0.06}, {10, 0, -2}), cube({})}));
  REQUIRE(world.step().ok);
  CHECK(state(world, 0).velocity.x > 8);
}
