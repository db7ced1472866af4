// SPDX-License-Identifier: MIT
// A solid of several convex pieces as bodies that are fixed to each other. Private to this folder.
#pragma once

#include <vector>

#include "robots/robot_model.h"
#include "robots/uses.h"

namespace stig::robots {

/// The bodies that a solid is made of. The first is `whole`, with the solid's first piece as its
/// hull; what it has of a frame, of mass and of moments, if they are given, is that of all. Mass,
/// middle and moments of all together are those of the solid, exactly.
std::vector<BodyModel> pieces_of(BodyModel whole, const SolidModel& solid);

}  // namespace stig::robots
