// SPDX-License-Identifier: MIT
// These stand for the firmware of motors and magnets. They are stepped with physics, not with
// control, since a ramp or a discharge may be over within a control step.
#include "robots/robot_devices.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace stig::robots {

namespace {

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

// A program may compute any number: infinities and NaN stop the wheel.
double cut(double speed, double most) {
  return std::isfinite(speed) ? std::clamp(speed, -most, most) : 0;
}

// Entries fall, so the first that is exceeded is the fastest that applies; an error below all of
// them is within the lift's tolerance.
double speed_at(const LiftModel& model, double error) {
  for (const auto& [above, speed] : model.speeds) {
    if (std::abs(error) > above) return std::copysign(speed, error);
  }
  return 0;
}

}  // namespace

void command(DriveState& state, const DriveModel& model, double left, double right) {
  assert(model.most_speed >= 0);
  state.left_target = cut(left, model.most_speed);
  state.right_target = cut(right, model.most_speed);
}

void step(DriveState& state, const DriveModel& model, double dt) {
  assert(dt > 0);
  const double most = model.most_acceleration * dt;
  state.left = towards(state.left, state.left_target, most);
  state.right = towards(state.right, state.right_target, most);
}

void command(LiftState& state, const LiftModel& model, const LiftCommand& command) {
  switch (command.kind) {
    case LiftCommand::Kind::none:
      return;
    case LiftCommand::Kind::stop:
      state.mode = LiftMode::rest;
      return;
    case LiftCommand::Kind::calibrate:
      state.mode = LiftMode::calibrating;
      return;
    case LiftCommand::Kind::position:
      if (!std::isfinite(command.position)) return;
      // A set height ends calibration as well: the last command holds.
      state.mode = LiftMode::moving;
      state.target = std::clamp(command.position, model.low, model.high);
      return;
  }
}

void step(LiftState& state, const LiftModel& model, double position) {
  assert(model.low <= model.high);
  if (state.mode == LiftMode::calibrating) {
    // Down at the slowest speed, as it does not know how far the bottom is.
    state.speed = model.speeds.empty() ? 0 : -model.speeds.back().second;
    if (position > model.low) return;
    state.target = model.low;
    state.mode = LiftMode::rest;
  }
  state.speed = state.mode == LiftMode::moving ? speed_at(model, state.target - position) : 0;
  // The switches stop the motor, whatever the target.
  const bool at_end = state.speed > 0 ? position >= model.high : position <= model.low;
  if (state.speed == 0 || at_end) {
    state.mode = LiftMode::rest;
    state.speed = 0;
  }
}

LiftReading reading_of(const LiftState& state, const LiftModel& model, double position) {
  LiftReading reading;
  reading.calibrating = state.mode == LiftMode::calibrating;
  // A lift that still creeps the last part of its way reports that it has arrived already.
  reading.active =
      reading.calibrating ||
      (state.mode == LiftMode::moving && std::abs(state.target - position) >= model.inactive_below);
  reading.position = position;
  reading.at_top = position >= model.high;
  reading.at_bottom = position <= model.low;
  return reading;
}

void step(MagnetState& state, const MagnetCircuitModel& model, double dt) {
  assert(dt > 0);
  const bool flows = state.mode != Discharge::disable;
  // charge' = gain - loss · charge has the solution below: an exponential towards gain / loss. The
  // limit is applied after the step, which is exact while charging is linear, or ends below it.
  const double gain = (flows ? model.sink_rate * model.sink_level : model.charge_per_second) +
                      model.relax_rate * model.charge_limit;
  const double loss = model.relax_rate + (flows ? model.discharge_per_second + model.sink_rate : 0);
  if (loss > 0) {
    state.charge = gain / loss + (state.charge - gain / loss) * std::exp(-loss * dt);
  } else {
    state.charge += gain * dt;
  }
  state.charge = std::clamp(state.charge, 0.0, model.charge_limit);
}

double current_of(const MagnetState& state) {
  assert(state.charge >= 0);
  switch (state.mode) {
    case Discharge::constructive:
      return state.charge;
    case Discharge::destructive:
      return -state.charge;
    case Discharge::disable:
      break;
  }
  return 0;
}

}  // namespace stig::robots
