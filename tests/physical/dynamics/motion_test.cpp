// SPDX-License-Identifier: MIT
// Bodies alone, against closed forms.
#include <rapidcheck.h>

#include "physical/support.h"
#include "support/uses.h"

using namespace stig;

TEST_CASE("free fall is exact") {
  BodyDef def = solid_body(Shape::box({0.1, 0.1, 0.1}), 2);
  def.X_WB.p = {0, 0, 20};
  def.velocity = {1, -2, 3};
  World world(single(def));
  run(world, 1);
  const BodyState end = state(world, 0);
  CHECK(length(end.X_WB.p - Vec3{1, -2, 20 + 3 - 4.9}) < 1e-9);
  CHECK(length(end.velocity - Vec3{1, -2, 3 - 9.8}) < 1e-9);
}

TEST_CASE("a spinning body keeps its angular momentum, and nearly its energy") {
  CHECK(rc::check("free top", [] {
    const auto value = [] { return *rc::gen::inRange(-100, 101) * 0.05; };
    BodyDef def = solid_body(Shape::box({0.1, 0.2, 0.35}), 1);
    def.spin = {value(), value(), value()};
    WorldConfig config = single(def);
    config.floor = false;
    config.gravity = 0;
    World world(config);
    const Vec3 inertia = inertia_of(def);
    const auto momentum = [&] {
      const BodyState s = state(world, 0);
      const Mat3 r = matrix(s.X_WB.q);
      return r * scaled(inertia, r.transposed(s.spin));
    };
    const Vec3 before = momentum();
    const double energy = world.energy();
    for (int i = 0; i < 400; ++i) RC_ASSERT(world.step().ok);
    RC_ASSERT(length(momentum() - before) <= 1e-10 * (length(before) + 1e-3));
    RC_ASSERT(std::abs(world.energy() - energy) <= 1e-3 * energy + 1e-12);
  }));
}

TEST_CASE("a body that spins about a main axis turns as far as it should") {
  BodyDef def = solid_body(Shape::box({0.1, 0.2, 0.35}), 1);
  def.spin = {0, 0, 2};
  WorldConfig config = single(def);
  config.floor = false;
  config.gravity = 0;
  World world(config);
  run(world, 1);
  const Mat3 r = matrix(state(world, 0).X_WB.q);
  CHECK(length(r.x - Vec3{std::cos(2.0), std::sin(2.0), 0}) < 1e-9);
}

TEST_CASE("pushes add momentum once, and wake") {
  BodyDef def = solid_body(Shape::sphere(0.05), 2);
  WorldConfig config = single(def);
  config.floor = false;
  config.gravity = 0;
  World world(config);
  world.push(BodyId{0}, {4, 0, 0}, {0, 0.02, 0});
  run(world, 0.1);
  CHECK(state(world, 0).velocity.x == doctest::Approx(4 * 0.005 / 2));
  CHECK(state(world, 0).spin.y == doctest::Approx(0.02 * 0.005 / (0.4 * 2 * 0.05 * 0.05)));
}

TEST_CASE("bodies that collide keep their momentum") {
  WorldConfig config;
  config.floor = false;
  config.gravity = 0;
  config.bodies.push_back(solid_body(Shape::box({0.1, 0.1, 0.1}), 1));
  config.bodies.push_back(solid_body(Shape::box({0.1, 0.2, 0.1}), 3));
  config.bodies.push_back(solid_body(Shape::sphere(0.05), 2));
  config.bodies[0].velocity = {1, 0, 0};
  config.bodies[1].X_WB = {{0.3, 0.06, 0.02}, normalised(rotation({0.1, 0.4, 0.2}))};
  config.bodies[2].X_WB.p = {0.6, 0.02, 0};
  World world(config);
  run(world, 2);
  Vec3 momentum, angular;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const BodyState s = state(world, i);
    const Mat3 r = matrix(s.X_WB.q);
    momentum += s.velocity * config.bodies[i].mass;
    angular += cross(s.X_WB.p, s.velocity) * config.bodies[i].mass +
               r * scaled(inertia_of(config.bodies[i]), r.transposed(s.spin));
  }
  CHECK(length(state(world, 2).velocity) > 0.01);  // it was hit
  CHECK(length(momentum - Vec3{1, 0, 0}) < 1e-12);
  // Points of contact are taken at the beginning of a step: a little is lost.
  CHECK(length(angular) < 1e-3);
}
