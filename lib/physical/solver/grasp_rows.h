// SPDX-License-Identifier: MIT
// Free bodies that a link holds as one joint: six rows each, solved as one block, in place of
// three for each of their points of contact. Used by solver.cpp alone.
#pragma once

#include <array>
#include <vector>

#include "physical/solver/six.h"
#include "physical/solver/solver.h"

namespace stig::physics {

struct GraspRow {
  double* v = nullptr;  ///< of the mechanism
  std::size_t dofs = 0;
  SolverBody* body = nullptr;
  std::vector<double> j;  ///< six rows: the link's twist at the body's centre, for unit velocities
  std::vector<double> w;  ///< likewise: what a unit of impulse there does to them
  std::array<double, 36> mass{};  ///< impulse for a unit of relative twist
  Six impulse{};                  ///< on the body, of a small step
  Six sum{};                      ///< of the step so far
};

using GraspRows = std::vector<GraspRow>;

void make_grasp_rows(SolverTask& task, GraspRows& rows);
/// Gives the impulses of the last small step.
void apply_last_grasps(GraspRows& rows);
/// Takes away the relative twists; returns the largest change of velocity, m/s.
double relax_grasps(GraspRows& rows);
/// After the sweeps of a small step.
void add_up_grasps(GraspRows& rows);
void keep_grasp_impulses(const GraspRows& rows, SolverTask& task);

}  // namespace stig::physics
