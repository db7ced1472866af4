// SPDX-License-Identifier: MIT
// The least time in which a robot could have brought the bricks that it placed, had it known
// everything and been alone: what its efficiency is measured against.
//
// For each brick: the way from where the effector let go of the last one (at first: from where it
// began) to the block, the pulses that attach it, the way to its cell, while which it is lifted,
// the way down on to its place, and the pulse that lets go of it. Ways are straight, at cruising
// speed, which is half the most that the drive can do (Allwright et al. 2017: 10.5 rad/s of wheels
// that do twice that), with the drive's acceleration at both ends. Turns, what stands in the way,
// and the way back from a placed brick are left out, so no robot reaches it.
#pragma once

#include <cstddef>
#include <span>

#include "base/vec.h"
#include "robots/robot_model.h"
#include "validate/uses.h"
#include "validate/watch.h"

namespace stig::validate {

/// Pulses of the electromagnets, s: those of the controller published with Allwright et al. 2017
/// (TR/IRIDIA/2017-003), which attach for 0.5 s and 1 s, and release for 1 s.
inline constexpr double kAttachTime = 1.5, kReleaseTime = 1;
/// How far a block is lifted over what it passes, m: its magnets reach 10.5 mm.
inline constexpr double kPassingHeight = 0.0105;

struct WorkSpeeds {
  double cruise = 0, acceleration = 0;  ///< m/s, m/s²; of the drive
  double lift = 0;                      ///< m/s
};
/// All zero for a robot without drive or lift: it has no ideal.
WorkSpeeds work_speeds(const RobotModel& robot);

/// Time for a straight way, s, from rest to rest. The speeds must be positive.
double straight_time(double way, const WorkSpeeds& speeds);

/// The ideal time, s, of the hauls of `robot` that brought bricks, in the order of their
/// beginnings; of several into one cell the last. `hand` is where its effector was at first. 0
/// where the robot has no ideal.
double ideal_time(std::span<const Haul> hauls, std::size_t robot, const Vec3& hand,
                  const WorkSpeeds& speeds);

}  // namespace stig::validate
