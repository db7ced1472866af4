// SPDX-License-Identifier: MIT
// What stands between commands and motors: the ramp of the wheels, the lift's way to a set
// height, the charge of the electromagnets. Small state machines in plain code, stepped with
// physics; they know nothing of a world.
#pragma once

#include "robots/robot_io.h"
#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

/// Speeds of the rims, m/s, forward.
struct DriveState {
  double left = 0, right = 0;                ///< what the motors are given now
  double left_target = 0, right_target = 0;  ///< what was commanded last
};
/// A command replaces the last one; speeds beyond the most are cut. Anything that is no number
/// counts as 0.
void command(DriveState& state, const DriveModel& model, double left, double right);
/// Goes towards the targets, at the most acceleration.
void step(DriveState& state, const DriveModel& model, double dt);

enum class LiftMode : std::uint8_t { rest, moving, calibrating };
struct LiftState {
  LiftMode mode = LiftMode::rest;
  double target = 0;  ///< m
  double speed = 0;   ///< m/s, what the motor is given now
};
/// Calibrating goes down to the bottom switch, where it rests. Heights beyond the switches are
/// cut; no number is no command.
void command(LiftState& state, const LiftModel& model, const LiftCommand& command);
/// Speed by error, see LiftModel; at a limit switch it goes no further. At rest it stays
/// within its tolerance until the next command.
void step(LiftState& state, const LiftModel& model, double position);
LiftReading reading_of(const LiftState& state, const LiftModel& model, double position);

/// Electromagnets of one circuit. While no current flows they charge; a current is the charge
/// itself, with its mode's sign, and takes from it:
///
///     charge' = charge_per_second                       (up to the limit; while disabled)
///             + relax_rate (charge_limit - charge)      (always)
///             - discharge_per_second charge             (while a current flows)
///             - sink_rate (charge - sink_level)         (while a current flows)
///
/// The first and third make the robot of 2017, the second and fourth the later one. Solved
/// exactly over a step, so that steps of any length end alike.
struct MagnetState {
  Discharge mode = Discharge::disable;
  double charge = 0;
};
void step(MagnetState& state, const MagnetCircuitModel& model, double dt);
/// Constructive current adds to the passive field, destructive takes from it.
double current_of(const MagnetState& state);

}  // namespace stig::robots
