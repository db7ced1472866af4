// SPDX-License-Identifier: MIT
// A free body that one part of a mechanism holds, and nothing else touches: a block on a robot's
// effector, mostly. As long as contacts can bear what holds it where it is, the solver takes it for
// a part of the mechanism, by one joint in place of all their points; that is all the difference.
//
// No grasp begins where contacts could clamp the body between them, as walls on both sides do.
// Elsewhere contacts can bear a wrench if there are forces at their points that add up to it, none
// of which pulls, and each within its cone of friction. They are looked for from those of the step
// before, by turns: the nearest that add up, the nearest within the cones (alternating
// projections). Where a few turns find none, the joint is given up, and what happens next is left
// to the contacts, which begin with the forces of the step before. So a joint never holds what
// contacts could not; what they would hold depends on how they share the load where more of them
// carry than have to.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physical/dynamics/uses.h"
#include "physical/solver/solver.h"

namespace stig::physics {

struct Grasp {
  std::uint32_t body = 0;
  std::int32_t articulation = -1;
  std::uint32_t part = 0;
  Pose X_PB;      ///< of the body in the part
  Twist impulse;  ///< of the last step on the body, about its centre, world frame
  /// With all vectors and places in the body's frame; sorted. Forces are those of the last step.
  std::vector<Contact> contacts;
  /// From what lacks of a wrench to the change of all forces, y + z × r at the place r, that makes
  /// up for it: y and z. Follows from the contacts.
  std::array<double, 36> spread{};
};

/// Works out what follows from the contacts. False: the points that touch are too few, on a line,
/// or could clamp the body.
bool complete(Grasp& grasp);
/// What the contacts' forces add up to, on the body about its centre, in its frame.
Twist wrench_of(const Grasp& grasp);
/// Changes the contacts' forces so that they add up to the impulse, in the body's frame. False, and
/// nothing changed: none are found.
bool bear(Grasp& grasp, const Twist& impulse_B);

/// A body that is on the way to be held: it has not moved in the part's frame for some steps.
struct Steady {
  std::uint32_t body = 0;
  std::int32_t articulation = -1;
  std::uint32_t part = 0;
  Pose X_PB;  ///< when they began
  std::uint32_t ticks = 0;
};

}  // namespace stig::physics
