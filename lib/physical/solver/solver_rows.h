// SPDX-License-Identifier: MIT
// The part of the solver that knows mechanisms: contacts of their bodies, contacts of wheels
// whose friction is an ellipse, motors and stops. Used by solver.cpp alone; made in
// solver_rows_make.cpp, swept in solver_rows.cpp, runs of them in robot_rows.cpp and
// mechanism_rows.cpp.
//
// A direction at a point is a row J of generalised velocities; an impulse along it changes
// them by W = M⁻¹Jᵀ. Sides that are free bodies keep their six numbers.
#pragma once

#include <array>
#include <vector>

#include "physical/solver/solver.h"

namespace stig::physics {

/// The three directions at a point: the normal, and tangents of which the first lies along the
/// axle.
inline constexpr std::size_t kNormal = 0, kFirst = 1, kSecond = 2;

/// A free body that a point acts on, or a fixed one that moves. Of each axis the number for the
/// velocity and the one for the spin stand side by side: they are added up side by side, too.
struct LooseSide {
  alignas(16) std::array<std::array<double, 6>, 3> j, w;
  double* v = nullptr;      ///< its velocity and spin, six numbers
  double* way = nullptr;    ///< the same of what is gone
  double inverse_mass = 0;  ///< here and in the rows: negative for the body that is pushed back
};

/// Which degrees of freedom move a link, in pairs: the first `begin` pairs and, where it is not
/// 0, pair number `extra`. Of an odd number of them the last stands alone. What J leaves out is
/// zero.
struct Reach {
  std::uint32_t begin = 0, extra = 0;

  /// J's numbers of one direction; even, so that pairs stay where the processor wants them.
  constexpr std::size_t width() const { return 2 * std::size_t{begin} + 4; }
};

/// A mechanism that a point acts on.
struct Hold {
  double* v = nullptr;
  double* way = nullptr;
  std::uint32_t dofs = 0;
  std::uint32_t at = 0;  ///< in Rows::numbers: J of the three directions, W of the three
  Reach reach;

  /// W's numbers of one direction; even, too.
  std::size_t height() const { return dofs + dofs % 2; }
};

/// What a point acts on: where it is one mechanism, with a free body or without, points that follow
/// each other are gone through with the velocities at hand (robot_rows.h, mechanism_rows.h).
enum class RowKind : std::uint8_t {
  any,
  robot,           ///< a robot with four wheels and a lift: chassis or lift, against what stands
  robot_on_loose,  ///< the same against one free body
  first_wheels,    ///< its first two wheels, or its last, against what stands
  last_wheels,
  mechanism,  ///< any mechanism against what stands
  mechanism_on_loose,
};

struct RowPoint {
  std::uint32_t contact = 0, point = 0;
  RowKind kind = RowKind::any;
  std::uint32_t looses = 0, held = 0;  ///< so many of either
  std::array<Hold, 2> holds;
  std::array<double, 3> mass{};  ///< impulse for a velocity change of 1 m/s, kg
  double gap = 0, push = 0;
  std::array<double, 2> slide{};
  double friction = 0, axle_friction = 1;
  std::array<double, 2> bend{};  ///< see bend()
  double shift_target = 0, shift = 0;
  std::array<Vec3, 3> directions;
  std::array<LooseSide, 2> loose;
};

/// Points that follow each other, of one kind and about the same velocities. Of those of any
/// kind, one.
struct RowRun {
  std::uint32_t begin = 0, end = 0;
};

struct Rows {
  std::vector<double> numbers;
  std::vector<Reach> reach;  ///< of the task's links
  std::vector<RowPoint> points;
  std::vector<RowRun> runs;
  std::vector<SolverAxis> axes;
};

/// Whether the contact is one for this file.
bool needs_rows(const SolverTask& task, std::size_t contact);

void make_rows(SolverTask& task, Rows& rows);
void apply_last_rows(const Rows& rows, SolverTask& task);
/// One sweep; returns the largest change of velocity, m/s.
double sweep_rows(Rows& rows, SolverTask& task, double inverse_dt);
void follow_row_gaps(Rows& rows, const SolverTask& task, double dt);
bool overlapping(const Rows& rows);
void shift_rows(Rows& rows);
void keep_row_impulses(const Rows& rows, SolverTask& task);

/// By how much two faces' velocities at a point, a against b, differ at the middle of the step
/// from those at its beginning, as far as the point goes round; m/s. Where less than faces touch:
/// none, since of what rolls other points touch by then.
Vec3 bend(const SolverTask& task, std::size_t contact, const Vec3& p_W);
/// Least normal velocity of the shift that undoes overlaps.
double least_shift(double gap, double dt);
/// Part of an overlap undone in a step.
inline constexpr double kOverlapCorrection = 0.1;

}  // namespace stig::physics
