// SPDX-License-Identifier: MIT
#include "robots/robot_devices.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "robots/robot_reader.h"
#include "support/golden.h"
#include "support/shipped_robot.h"
#include "support/uses.h"

namespace stig {
namespace {

/// A lift that does what it is told: the time until it reports rest, s.
double travel(LiftState& state, const LiftModel& model, double& position, double dt = 0.005) {
  double time = 0;
  do {
    step(state, model, position);
    position += state.speed * dt;
    time += dt;
  } while (state.mode != LiftMode::rest && time < 100);
  return time;
}

const double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("wheels are ramped and never too fast") {
  DriveModel model;
  model.most_speed = 0.33;
  model.most_acceleration = 1;
  DriveState state;
  command(state, model, 0.165, -1);
  CHECK(state.right_target == -0.33);
  for (int i = 0; i < 20; ++i) step(state, model, 0.005);
  CHECK(state.left == doctest::Approx(0.1));
  CHECK(state.right == doctest::Approx(-0.1));
  for (int i = 0; i < 60; ++i) step(state, model, 0.005);
  CHECK(state.left == 0.165);
  CHECK(state.right == -0.33);
  command(state, model, kNaN, std::numeric_limits<double>::infinity());
  CHECK(state.left_target == 0);
  CHECK(state.right_target == 0);
}

TEST_CASE("the lift of 2017: fast far off, slow near, at rest within 1 mm") {
  const LiftModel model = *shipped_robot("bebot.yaml").lift;
  LiftState state;
  double position = 0.02;
  command(state, model, {LiftCommand::Kind::position, 0.08});
  step(state, model, position);
  CHECK(state.speed == 0.15);
  step(state, model, 0.071);
  CHECK(state.speed == 0.075);
  step(state, model, 0.089);
  CHECK(state.speed == -0.075);
  CHECK(reading_of(state, model, 0.089).active);
  CHECK_FALSE(reading_of(state, model, 0.0845).active);
  step(state, model, 0.0809);
  CHECK(state.speed == 0);
  CHECK(state.mode == LiftMode::rest);
  // 50 mm at 0.15 m/s and 10 mm at 0.075 m/s, less the tolerance.
  command(state, model, {LiftCommand::Kind::position, 0.08});
  const double time = travel(state, model, position);
  CHECK(time == doctest::Approx(0.050 / 0.15 + 0.009 / 0.075).epsilon(0.03));
  CHECK(std::abs(position - 0.08) <= 0.001);
}

TEST_CASE("switches, calibration, stop") {
  const LiftModel model = *shipped_robot("bebot.yaml").lift;
  LiftState state;
  double position = 0.05;
  command(state, model, {LiftCommand::Kind::position, 9});
  travel(state, model, position);
  CHECK(position == doctest::Approx(0.137).epsilon(0.01));
  CHECK(reading_of(state, model, 0.137).at_top);
  CHECK_FALSE(reading_of(state, model, 0.137).at_bottom);
  command(state, model, {LiftCommand::Kind::calibrate, 0});
  step(state, model, position);
  CHECK(reading_of(state, model, position).calibrating);
  CHECK(reading_of(state, model, position).active);
  travel(state, model, position);
  CHECK(position <= 0.0005);
  CHECK(reading_of(state, model, position).at_bottom);
  command(state, model, {LiftCommand::Kind::position, 0.1});
  step(state, model, position);
  command(state, model, {LiftCommand::Kind::none, 0});
  CHECK(state.mode == LiftMode::moving);
  command(state, model, {LiftCommand::Kind::position, kNaN});
  CHECK(state.target == 0.1);
  command(state, model, {LiftCommand::Kind::stop, 0});
  step(state, model, position);
  CHECK(state.speed == 0);
}

TEST_CASE("the later lift takes its time") {
  const LiftModel model = *shipped_robot("builderbot.yaml").lift;
  LiftState state;
  double position = 0.0005;
  command(state, model, {LiftCommand::Kind::position, 0.137});
  CHECK(travel(state, model, position) ==
        doctest::Approx(0.1265 / 0.018 + 0.009 / 0.010).epsilon(0.02));
}

TEST_CASE("the magnets of 2017: 10 a step up to 250, a fortieth a step down") {
  const MagnetCircuitModel model = *shipped_robot("bebot.yaml").magnets;
  MagnetState state;
  for (int tick = 1; tick <= 24; ++tick) {
    step(state, model, 0.2);
    CHECK(state.charge == doctest::Approx(10.0 * tick));
  }
  for (int tick = 0; tick < 3; ++tick) step(state, model, 0.2);
  CHECK(state.charge == 250);
  CHECK(current_of(state) == 0);
  state.mode = Discharge::constructive;
  CHECK(current_of(state) == 250);
  step(state, model, 0.2);
  CHECK(state.charge == doctest::Approx(250 * 0.975).epsilon(1e-6));
  state.mode = Discharge::destructive;
  CHECK(current_of(state) == doctest::Approx(-250 * 0.975).epsilon(1e-6));
}

TEST_CASE("the later magnets: dV/dt = 0.38 (22.9 - V) - 1.3 (V - 6.5)") {
  const MagnetCircuitModel model = *shipped_robot("builderbot.yaml").magnets;
  MagnetState state, slow;
  step(state, model, 1);
  CHECK(state.charge == doctest::Approx(22.9 * (1 - std::exp(-0.38))));
  // The same in small Euler steps, also while a current flows.
  state.mode = slow.mode = Discharge::destructive;
  state.charge = slow.charge = 20;
  step(state, model, 0.5);
  for (int i = 0; i < 500'000; ++i) {
    slow.charge += 1e-6 * (0.38 * (22.9 - slow.charge) - 1.3 * (slow.charge - 6.5));
  }
  CHECK(state.charge == doctest::Approx(slow.charge).epsilon(1e-5));
  // Steps of any length end alike.
  MagnetState fine = {Discharge::destructive, 20};
  for (int i = 0; i < 100; ++i) step(fine, model, 0.005);
  CHECK(fine.charge == doctest::Approx(state.charge).epsilon(1e-12));
}

}  // namespace stig
