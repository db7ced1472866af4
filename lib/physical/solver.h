// SPDX-License-Identifier: MIT
// The contact solver: projected Gauss–Seidel on velocities, without a matrix, warm-started,
// with Coulomb's cone for friction.
//
// For each point, with the normal n from b to a and the gap g:
//
//     v·n >= -max(g, 0) / dt,
//
// where v is the velocity of a against b at the point; the normal impulse pushes only, and
// the tangential one is at most the friction coefficient times it, in every direction.
// Points a little apart take part (speculatively): without them walls jitter. Overlaps of
// more than 50 µm are undone by a tenth a step, at most at 0.05 m/s, by a shift that is no
// part of the velocities.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "physical/contact.h"

namespace stig {

/// The other side of a contact with the floor.
inline constexpr std::uint32_t kFloorBody = 0xffffffff;

struct ContactPoint {
  Vec3 p_W;
  Vec3 p_A;  ///< in a's frame: how the point is found again a step later
  double gap = 0;
  double push = 0;  ///< normal impulse, N·s
  Vec3 friction;    ///< tangential impulse on a, N·s, world frame
};

struct Contact {
  std::uint32_t a = 0, b = kFloorBody;
  Vec3 normal;  ///< unit, from b to a
  std::array<ContactPoint, 4> points;
  int count = 0;
  double friction = 0.5;
  bool touching = false;  ///< has been nearer than 50 µm since the contact began
};

/// Takes over the impulses of the last step: from the nearest old point within 3 mm, when
/// the normals agree.
void warm_start(Contact& contact, const Contact& last);

/// What the solver needs of a body, and changes.
struct SolverBody {
  Vec3 p;  ///< centre of mass
  Vec3 v, w;
  Vec3 shift_v, shift_w;    ///< out: added to v and w for this step's way alone
  double inverse_mass = 0;  ///< 0: moved by nothing
  Mat3 inverse_inertia{{}, {}, {}};
};

/// Changes the velocities of `bodies` so that contacts hold; impulses stay in `contacts`.
/// Contacts name bodies by their place in `bodies`, the floor by that of an immovable one.
void solve_contacts(std::vector<SolverBody>& bodies, std::vector<Contact>& contacts,
                    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& slots, double dt,
                    int sweeps);

}  // namespace stig
