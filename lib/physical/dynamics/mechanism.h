// SPDX-License-Identifier: MIT
// The kinematics of a tree of rigid parts, by DART; what is made of them (mass matrix, Coriolis
// forces, contacts, motors, time) is plain code in articulation.cpp. DART's own Coriolis forces
// took a third of the time of a robot's step.
//
// An interface, so that one file alone knows DART.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/vec.h"
#include "physical/dynamics/joint.h"
#include "physical/dynamics/uses.h"
#include "physical/solver/solver.h"

namespace stig::physics {

/// A rigid part: bodies that are fixed to each other, as one.
struct Part {
  int parent = -1;        ///< an earlier part, or the world
  bool floating = false;  ///< the first part, when no joint holds it: six degrees of freedom
  Pose X_PJ, X_CJ;        ///< of the joint to the parent
  std::vector<DofDef> dofs;
  double mass = 0;
  Vec3 centre;   ///< of mass, in the part's frame
  Mat3 inertia;  ///< about that centre, in the part's axes
};

/// Keeps nothing but the positions set last, so that articulations that move alike may share one.
class Mechanism {
 public:
  Mechanism() = default;
  Mechanism(const Mechanism&) = delete;
  Mechanism& operator=(const Mechanism&) = delete;
  virtual ~Mechanism() = default;

  virtual std::size_t dofs() const = 0;
  /// The first six positions and velocities, those of a floating first part.
  virtual void place(const Pose& X_WP, const Twist& motion, double* q, double* v) = 0;
  /// Positions that all below answer for.
  virtual void set_positions(const double* q) = 0;
  virtual Pose pose(std::size_t part) const = 0;
  /// Motion of the part's origin for unit velocity of each degree of freedom, world axes.
  virtual void columns(std::size_t part, Twist* out) const = 0;
  /// Moves positions, which are those set, with a velocity. They are to be set again.
  virtual void integrate(double* q, const double* v, double dt) = 0;
};

/// DART is not safe to make and unmake in several threads: both take
/// a lock that is the process's.
std::shared_ptr<Mechanism> make_mechanism(const std::vector<Part>& parts);

}  // namespace stig::physics
