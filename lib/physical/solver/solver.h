// SPDX-License-Identifier: MIT
// The contact solver: projected Gauss–Seidel on velocities, without a matrix, warm-started,
// with Coulomb's cone for friction, in small steps (Macklin et al. 2019, "Small steps in
// physics simulation"): forces come in parts, each followed by a few sweeps, and gaps follow
// the velocities. High columns stand so with the work of as many sweeps at once, with which
// they fall.
//
// For each point, with the normal n from b to a and the gap g:
//
//     v·n >= -max(g, 0) / dt,
//
// where v is the velocity of a against b at the point; the normal impulse pushes only, and
// the tangential one is at most the friction coefficient times it, in every direction (along
// a wheel's axle: less, an ellipse). Points a little apart take part (speculatively): without
// them walls jitter. Overlaps of more than 50 µm are undone by a tenth a step, at most at
// 0.05 m/s, by a shift that is no part of the velocities.
//
// Where faces touch, friction is about what they do at the middle of the step: velocities at its
// beginning lead along tangents, and what a robot carries through a bend would creep outwards.
//
// Bodies of a mechanism move by its generalised velocities; its motors and stops are rows
// of the same solver, and so is what one of its links holds.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "physical/collision/contact.h"

namespace stig::physics {

/// The other side of a contact with the floor.
inline constexpr std::uint32_t kFloorBody = 0xffffffff;

/// m: points that are nearer touch; what is farther apart is seen ahead of time.
inline constexpr double kTouching = 50e-6;

struct ContactPoint {
  Vec3 p_W;
  Vec3 p_A;  ///< in a's frame: how the point is found again a step later
  double gap = 0;
  double push = 0;  ///< normal impulse of a step, N·s
  Vec3 friction;    ///< tangential impulse on a, N·s, world frame
};

struct Contact {
  std::uint32_t a = 0, b = kFloorBody;
  Vec3 normal;  ///< unit, from b to a
  std::array<ContactPoint, 4> points;
  int count = 0;
  double friction = 0.5;
  Vec3 axle;                 ///< unit, world frame; zero: the same friction in all directions
  double axle_friction = 1;  ///< times `friction`, along the axle
  bool touching = false;     ///< has been nearer than kTouching since the contact began
};

/// Takes over the impulses of the last step: from the nearest old point within 3 mm, when
/// the normals agree.
void warm_start(Contact& contact, const Contact& last);

/// A velocity and a spin.
struct Twist {
  Vec3 v, w;
};

/// What the solver needs of a body, and changes.
struct SolverBody {
  Vec3 p;                   ///< centre of mass
  Vec3 v, w;                ///< in: before this step's forces; out: after contacts
  Vec3 kick_v, kick_w;      ///< what the forces add over the step
  Vec3 way_v, way_w;        ///< out: the step's way is this times dt
  double inverse_mass = 0;  ///< 0: moved by nothing, or by its mechanism
  Mat3 inverse_inertia{{}, {}, {}};
  std::int32_t link = -1;  ///< of a mechanism: its place in `links`
};

/// The most degrees of freedom of a mechanism: its inverse is dense.
inline constexpr std::size_t kMostMechanismDofs = 64;

/// The motion of a mechanism. Pointers are to as many numbers as it has degrees of freedom.
struct SolverMechanism {
  std::size_t dofs = 0;
  const double* inverse = nullptr;  ///< of the mass matrix: dofs × dofs
  double* v = nullptr;              ///< as v of a SolverBody
  const double* kick = nullptr;
  double* way = nullptr;
};

/// How a body follows its mechanism.
struct SolverLink {
  std::uint32_t mechanism = 0;
  Vec3 p;                          ///< point that `columns` are about
  const Twist* columns = nullptr;  ///< for unit velocity of each degree of freedom
  Vec3 w, change_v, change_w;      ///< its spin, and how the point and the spin accelerate
};

/// A motor or a stop: acts on one degree of freedom.
struct SolverAxis {
  std::uint32_t mechanism = 0, dof = 0;
  int side = 0;        ///< 0: a motor; of a stop: the direction in which it pushes
  double target = 0;   ///< of a motor: m/s or rad/s
  double most = 0;     ///< of a motor: impulse of a step, N·s or N·m·s
  double gap = 0;      ///< of a stop: the way to it, m or rad
  double impulse = 0;  ///< in: last step's; out: this one's
};

/// A free body that a link holds as if it were a part of it.
struct SolverGrasp {
  std::uint32_t link = 0, body = 0;  ///< places in `bodies`
  Twist impulse;  ///< on the body about its centre: N·s and N·m·s; in: last step's; out: this one's
};

struct SolverTask {
  std::vector<SolverBody> bodies;
  std::vector<SolverMechanism> mechanisms;
  std::vector<SolverLink> links;
  std::vector<SolverAxis> axes;
  std::vector<SolverGrasp> grasps;
  std::vector<Contact> contacts;
  /// Places in `bodies` of each contact's two; the floor is an immovable one.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> slots;
  double dt = 0.005;
  int small_steps = 16;
  int sweeps = 1;  ///< in each of them
};

/// Changes velocities so that contacts, motors and stops hold; impulses stay in the task.
void solve(SolverTask& task);

}  // namespace stig::physics
