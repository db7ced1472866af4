// SPDX-License-Identifier: MIT
// A robot on four wheels with a lift: driving, turning, resting, lifting.

#include "physical/dynamics/car.h"
#include "support/uses.h"

#include <cmath>

using namespace stig;

namespace {

double heading(const World& world, const Car& car) {
  const Vec3 x = matrix(state(world, car.chassis).X_WB.q).x;
  return std::atan2(x.y, x.x);
}

/// Turns on the spot until the heading has gone round; the time taken, s.
double time_of_turn(double axle_friction, double speed) {
  WorldConfig config = car_settings();
  const Car car = add_car(config, {}, axle_friction);
  World world(config);
  drive(world, car, -speed, speed);
  double turned = 0, last = 0;
  while (turned < 2 * 3.14159265358979) {
    REQUIRE(world.time() < 20);
    REQUIRE(world.step().ok);
    const double now = heading(world, car);
    turned += std::remainder(now - last, 2 * 3.14159265358979);
    last = now;
  }
  CHECK(std::hypot(state(world, car.chassis).X_WB.p.x, state(world, car.chassis).X_WB.p.y) < 0.02);
  return world.time();
}

/// How far a block slides on a robot's top, m, in half a second under a level push of so many times
/// what friction holds, in a direction, rad.
double slide_on_top(double times, double direction) {
  WorldConfig config = car_settings();
  add_car(config);
  const double mass = 0.1, top = 0.08025 + 0.28775;
  const auto block = static_cast<std::uint32_t>(config.bodies.size());
  config.bodies.push_back(solid_body(Shape::box({0.055, 0.055, 0.055}), mass));
  config.bodies.back().X_WB.p = {0, 0, top + 0.0275};
  World world(config);
  const double force = times * config.friction * mass * 9.8;
  world.add_force([=](const World&, Forces& forces) {
    forces.add(BodyId{block}, {force * std::cos(direction), force * std::sin(direction), 0}, {});
  });
  run(world, 0.5);
  const Vec3 p = state(world, block).X_WB.p;
  return std::hypot(p.x, p.y);
}

}  // namespace

TEST_CASE("a block on a robot slides as easily in every direction") {
  for (const double degrees : {0.0, 30.0, 60.0, 90.0, 135.0}) {
    CAPTURE(degrees);
    const double direction = degrees / 180 * 3.14159265358979;
    CHECK(slide_on_top(0.8, direction) < 5e-4);
    CHECK(slide_on_top(1.2, direction) > 5e-3);
  }
}

TEST_CASE("a car of the paper's figures weighs what they say") {
  WorldConfig config = car_settings();
  add_car(config);
  CHECK(config.bodies.size() == 15);
  CHECK(problems_of(config).empty());
  double mass = 0;
  for (const BodyDef& def : config.bodies) mass += def.mass;
  CHECK(mass == doctest::Approx(2.295));
}

TEST_CASE("a car drives a metre straight, as far as its wheels turn") {
  WorldConfig config = car_settings();
  const Car car = add_car(config, {{}, rotation({0, 0, 1})});
  World world(config);
  // A ramp, as motors with limited acceleration make it.
  const double cruise = 0.165;
  for (double speed = 0; speed < cruise; speed += 0.005) {
    drive(world, car, speed, speed);
    REQUIRE(world.step().ok);
  }
  const auto turns = [&] { return world.joint(car.wheels[0])[0].position; };
  const double start = turns();
  const Vec3 from = state(world, car.chassis).X_WB.p;
  drive(world, car, cruise, cruise);
  const double begin = world.time();
  while (world.time() < begin + 1 / cruise) REQUIRE(world.step().ok);
  const Vec3 way = state(world, car.chassis).X_WB.p - from;
  CHECK(length(way) == doctest::Approx(1).epsilon(0.02));
  CHECK(length(way) == doctest::Approx((turns() - start) * kWheelRadius).epsilon(0.01));
  CHECK(std::abs(way.x * std::sin(1) - way.y * std::cos(1)) < 0.005);
  CHECK(std::abs(way.z) < 1e-4);
}

TEST_CASE("a car turns on the spot as kinematics says") {
  const double speed = 0.082;
  const double theory = 2 * 3.14159265358979 * (kTrack / 2) / speed;
  CHECK(time_of_turn(0.2, speed) == doctest::Approx(theory).epsilon(0.02));
}

TEST_CASE("a car at rest stays where it is, asleep or not") {
  for (const bool sleep : {true, false}) {
    WorldConfig config = car_settings();
    config.sleep.enabled = sleep;
    const Car car = add_car(config);
    World world(config);
    run(world, 20);
    const Vec3 way = state(world, car.chassis).X_WB.p - config.bodies[car.chassis].X_WB.p;
    CHECK(length(way) < 1e-4);
    CHECK((world.awake_count() == 0) == sleep);
  }
}

TEST_CASE("a lift carries a block up and down again") {
  WorldConfig config = car_settings();
  const Car car = add_car(config);
  const Vec3 plate = config.bodies[car.plate].X_WB.p;
  // On top of the plate, in front of the mast.
  config.bodies.push_back(
      block_body(without_magnets(paper_block()), {plate + Vec3{0.025, 0, 0.0325 + 0.0235}, {}}));
  REQUIRE(problems_of(config).empty());
  const auto block = static_cast<std::uint32_t>(config.bodies.size() - 1);
  World world(config);
  run(world, 0.5);
  const double low = state(world, block).X_WB.p.z;
  const auto lift = [&] { return world.joint(car.lift)[0].position; };
  CHECK(std::abs(lift()) < 0.001);
  world.drive(car.lift, 0, 0.1);
  run(world, 2);
  CHECK(lift() == doctest::Approx(0.1375).epsilon(0.01));
  CHECK(state(world, block).X_WB.p.z - low == doctest::Approx(lift()).epsilon(0.02));
  world.drive(car.lift, 0, 0);
  run(world, 1);
  CHECK(lift() == doctest::Approx(0.1375).epsilon(0.01));
  world.drive(car.lift, 0, -0.1);
  run(world, 2);
  CHECK(lift() == doctest::Approx(-0.0005).epsilon(0.01));
  CHECK(std::abs(state(world, block).X_WB.p.z - low) < 0.002);
}

TEST_CASE("what lies on a car that turns, and what lies upon that, does not creep outwards") {
  WorldConfig config = car_settings();
  const Car car = add_car(config);
  const Vec3 plate = config.bodies[car.plate].X_WB.p;
  for (const double height : {0.056, 0.111 - 1e-5}) {
    config.bodies.push_back(
        block_body(without_magnets(paper_block()), {plate + Vec3{0.025, 0, height}, {}}));
  }
  REQUIRE(problems_of(config).empty());
  World world(config);
  run(world, 0.3);
  for (double speed = 0; speed < 0.0285; speed += 0.0005) {
    drive(world, car, -speed, speed);  // in the end 1 rad/s
    REQUIRE(world.step().ok);
  }
  run(world, 0.5);
  const auto upper = static_cast<std::uint32_t>(config.bodies.size() - 1);
  // In the plate's frame.
  const auto place = [&](std::uint32_t block) {
    return inverse(state(world, car.plate).X_WB) * state(world, block).X_WB.p;
  };
  const Vec3 low = place(upper - 1), high = place(upper);
  run(world, 5);
  // Along tangents it would be 1 mm.
  CHECK(length(place(upper - 1) - low) < 0.05e-3);
  CHECK(length(place(upper) - high) < 0.05e-3);
}

TEST_CASE("a car pushes a block, and a wall stops it without ado") {
  WorldConfig config = car_settings();
  const Car car = add_car(config);
  config.bodies.push_back(
      block_body(without_magnets(paper_block()), {{0.3, 0, 0.0275 - 1e-5}, {}}));
  const auto block = static_cast<std::uint32_t>(config.bodies.size() - 1);
  BodyDef wall = solid_body(Shape::box({0.05, 1, 0.2}), 1, {0.6, 0, 0.1});
  wall.fixed = true;
  config.bodies.push_back(wall);
  World world(config);
  run(world, 1);
  CHECK(world.awake_count() == 0);
  drive(world, car, 0.1, 0.1);
  run(world, 8);
  // The plate, above the block, meets the wall; the lift's link has pushed the block.
  const double expected = 0.575 - 0.129755 + 0.057755 + 0.0275;
  CHECK(state(world, block).X_WB.p.x == doctest::Approx(expected).epsilon(0.005));
  CHECK(length(state(world, block).velocity) < 0.01);
  CHECK(std::abs(matrix(state(world, car.chassis).X_WB.q).z.z - 1) < 1e-3);
}
