// SPDX-License-Identifier: MIT
// The dynamics of a mechanism in generalised coordinates: from forces on its bodies to
// velocities, and from velocities to poses.
//
//     M(q) dv/dt + c(q, v) + D v = Jᵀ F + τ
//
// with DART's kinematics. Of what hangs in the world, positions and
// velocities leap over each other (pendulums keep their energy); of what flies, positions go
// with the mean of the velocities (falling is exact). c is taken at the middle of the velocities'
// step (second order), viscous friction D at its end, so that it never overshoots. Of a mechanism
// that nothing holds in the world, the momentum is put right after each step: it changes by the
// outer forces' impulse alone, to rounding.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "physical/dynamics/mechanism.h"
#include "physical/dynamics/uses.h"
#include "physical/dynamics/world_config.h"

namespace stig::physics {

struct Body;

/// A body of a mechanism.
struct LinkBody {
  std::uint32_t body = 0;  ///< its number in the world
  std::size_t part = 0;
  Pose X_PB;  ///< in the part
};

/// A part where it is now.
struct PartWeight {
  double mass = 0;
  Vec3 centre;   ///< of mass, from the part's origin, world axes
  Mat3 inertia;  ///< about that centre, world axes
};

struct AxisState {
  double target = 0;  ///< of the actuator
  double motor = 0;   ///< impulse of the last step
  double stop = 0;    ///< positive: from the lower stop
};

/// The momentum of a system of bodies: linear, and angular about the world's origin.
struct Momentum {
  Vec3 linear, angular;
};

struct Articulation {
  std::vector<Part> parts;
  std::vector<LinkBody> links;
  bool floating = false;
  std::shared_ptr<Mechanism> mechanism;
  std::vector<std::vector<std::uint32_t>> chains;  ///< degrees of freedom that move each part

  // By place in q and v; a floating first part has the first six.
  std::vector<DofDef> dofs;
  std::vector<AxisState> axes;
  std::vector<double> q, v;

  // Functions of the positions q.
  std::vector<Pose> poses;          ///< of the parts
  std::vector<Twist> columns;       ///< parts × dofs: see Mechanism::columns
  std::vector<PartWeight> weights;  ///< of the parts
  std::vector<Twist> motions;       ///< of the parts' origins, for v

  // Values of this step.
  std::vector<double> kick, way;
  std::vector<double> inverse;  ///< of M + D dt, dofs × dofs
  Momentum momentum;            ///< that it should have after the step, but for contacts
  Momentum kicked;              ///< with the forces' velocities, where it stood
  bool held = false;            ///< by contacts, motors or stops

  std::size_t size() const { return q.size(); }
  const Twist* columns_of(std::size_t part) const { return &columns[part * size()]; }
};

/// Where a joint's degrees of freedom are.
struct JointPlace {
  std::uint32_t articulation = 0, first = 0;
};

struct Articulations {
  std::vector<Articulation> all;
  std::vector<JointPlace> joints;  ///< by number in the configuration
};

/// Adds the joints from number `first` on; those before must not share bodies with them.
void add_articulations(const WorldConfig& config, std::size_t first, Articulations& out);

/// How a part's origin moves at generalised velocities v, and how that would change if they stayed
/// the same.
struct PartMotion {
  Twist motion, change;
};
PartMotion part_motion(const Articulation& articulation, std::size_t part,
                       const std::vector<double>& v);

/// Poses and velocities of the bodies, from those of the parts.
void place_bodies(const Articulation& articulation, std::vector<Body>& bodies);
void set_body_velocities(const Articulation& articulation, std::vector<Body>& bodies);

/// Takes positions and velocities anew, after they were set from outside.
void refresh(Articulation& articulation);
/// Takes the velocities anew.
void note_motions(Articulation& articulation);
/// Adds to velocities what the forces on the bodies do in a step.
void kick(Articulation& articulation, const std::vector<Body>& bodies, double dt);
/// Moves with the velocities that the solver has left.
void move(Articulation& articulation, double dt);

/// Appends the motors and stops of a mechanism; `number` is its place in the solver's list.
void add_axes(const Articulation& articulation, std::uint32_t number, double dt,
              std::vector<SolverAxis>& out);
/// Keeps their impulses; returns the place behind them.
std::size_t keep_axes(Articulation& articulation, const std::vector<SolverAxis>& axes,
                      std::size_t at);

/// That the actuator applied in the last step, N or N·m.
double motor_force(const Articulation& articulation, std::size_t dof, double dt);

/// Whether an actuator has something to do, so that the mechanism may not sleep.
bool driven(const Articulation& articulation);

}  // namespace stig::physics
