// SPDX-License-Identifier: MIT
// About which point a robot turns on the spot.
#pragma once

#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

/// x of that point in frame R, m; of a robot that has a differential drive. 0 where that has no
/// wheels, which no file says.
///
/// In a turn wheels that are before or behind the point scrub sideways. Their friction does not
/// depend on speed (Coulomb), so a turn about x takes the work Σ μ Nᵢ |xᵢ − x| for each radian,
/// and the robot turns where that is least: at the median of its wheels' places, weighted with the
/// loads Nᵢ that they bear. Of two axles it is the one that bears more. What else touches the floor
/// bears load too, and is taken to slide freely, as a caster does.
double pivot_of(const RobotModel& robot);

}  // namespace stig::robots
