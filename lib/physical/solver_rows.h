// SPDX-License-Identifier: MIT
// The part of the solver that knows mechanisms: contacts of their bodies, contacts of wheels
// whose friction is an ellipse, motors and stops. Used by solver.cpp alone.
//
// A direction at a point is a row J of generalised velocities; an impulse along it changes
// them by W = M⁻¹Jᵀ. Sides that are free bodies keep their six numbers.
#pragma once

#include <vector>

#include "physical/solver.h"

namespace stig {

/// One direction at a point. Arms and turns are of its free bodies, and zero where there are none.
struct Row {
  Vec3 d, arm_a, arm_b, turn_a, turn_b;
  double mass = 0;  ///< impulse for a velocity change of 1 m/s, kg
};

/// A mechanism that a point holds at.
struct Hold {
  double* v = nullptr;  ///< its velocities
  double* way = nullptr;
  std::uint32_t dofs = 0;
  std::uint32_t link = 0;  ///< see Rows::reach
  std::uint32_t at = 0;    ///< in Rows::numbers: J of the three directions, W of the three
};

struct RowPoint {
  std::array<Row, 3> rows;  ///< normal and tangents, of which the first lies along the axle
  std::array<Hold, 2> holds;
  std::uint32_t held = 0;  ///< so many of them
  std::uint32_t contact = 0, point = 0;
  std::uint32_t a = 0, b = 0;
  bool loose_a = false, loose_b = false;  ///< free bodies, or fixed ones that move
  double gap = 0, push = 0, slide_first = 0, slide_second = 0;
  double friction = 0, axle_friction = 1;
  double bend_first = 0, bend_second = 0;  ///< see bend()
  double shift_target = 0, shift = 0;
};

/// Which degrees of freedom move a link, as pairs: 2k and 2k + 1 for each k of Rows::pairs from
/// `begin` on. J has as many numbers, and one more for the last of an odd number of them.
struct Reach {
  std::uint32_t begin = 0, count = 0;
};

struct Rows {
  std::vector<double> numbers;
  std::vector<std::uint32_t> pairs;
  std::vector<Reach> reach;  ///< of the task's links
  std::vector<RowPoint> points;
  std::vector<SolverAxis> axes;
};

/// Whether the contact is one for this file.
bool needs_rows(const SolverTask& task, std::size_t contact);

void make_rows(const SolverTask& task, Rows& rows);
void apply_last_rows(const Rows& rows, SolverTask& task);
/// One sweep; returns the largest change of velocity, m/s.
double sweep_rows(Rows& rows, SolverTask& task, double inverse_dt);
void follow_row_gaps(Rows& rows, const SolverTask& task, double dt);
bool overlapping(const Rows& rows);
void shift_rows(Rows& rows, SolverTask& task);
void keep_row_impulses(const Rows& rows, SolverTask& task);

/// By how much two faces' velocities at a point, a against b, differ at the middle of the step
/// from those at its beginning, as far as the point goes round; m/s. Where less than faces touch:
/// none, since of what rolls other points touch by then.
Vec3 bend(const SolverTask& task, std::size_t contact, const Vec3& p_W);
/// Least normal velocity of the shift that undoes overlaps.
double least_shift(double gap, double dt);

}  // namespace stig
