// SPDX-License-Identifier: MIT
// Projected Gauss and Seidel over rows of generalised velocities: J v is the velocity at a point
// along a direction, and an impulse there changes v by W = M⁻¹ Jᵀ, both worked out once a step. The
// order of points is that of contacts, and runs of one kind go through code of their own.
#include "physical/solver/solver_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "physical/solver/robot_rows.h"
#include "physical/solver/row_numbers.h"

namespace stig::physics {

namespace {

/// Adds W times an impulse in each of `kCount` directions, one after the other.
template <std::size_t kCount>
void add(const double* w, const Hold& hold, const std::array<double, kCount>& impulse, double* v) {
  const std::size_t n = hold.dofs, height = hold.height();
  for (std::size_t k = 0; k < n / 2; ++k) {
    Two sum = two_at(v + 2 * k);
    for (std::size_t i = 0; i < kCount; ++i) {
      sum += row_two(w + i * height + 2 * k) * both(impulse[i]);
    }
    put(v + 2 * k, sum);
  }
  if (n % 2 == 0) return;
  for (std::size_t i = 0; i < kCount; ++i) v[n - 1] += w[i * height + n - 1] * impulse[i];
}

/// Velocity and spin along the axis i.
Two axis_at(const double* v, std::size_t i) { return Two{v[i], v[3 + i]}; }

double product(const std::array<double, 6>& j, const double* v) {
  Two sum = row_two(&j[0]) * axis_at(v, 0);
  sum += row_two(&j[2]) * axis_at(v, 1);
  sum += row_two(&j[4]) * axis_at(v, 2);
  return sum[0] + sum[1];
}

/// The same for a free body, whose velocity and spin are paired by axis.
template <std::size_t kCount>
void add(const LooseSide& side, std::size_t direction, const std::array<double, kCount>& impulse,
         double* v) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Two sum = axis_at(v, axis);
    for (std::size_t i = 0; i < kCount; ++i) {
      sum += row_two(&side.w[direction + i][2 * axis]) *
             Two{impulse[i] * side.inverse_mass, impulse[i]};
    }
    v[axis] = sum[0];
    v[3 + axis] = sum[1];
  }
}

/// The velocity at a point along a direction.
template <class Of = OfVelocities>
double along(std::size_t direction, const Rows& rows, const RowPoint& point) {
  double sum = 0;
  for (std::size_t i = 0; i < point.looses; ++i) {
    sum += product(point.loose[i].j[direction], Of::of(point.loose[i]));
  }
  for (std::size_t i = 0; i < point.held; ++i) {
    const Hold& hold = point.holds[i];
    sum += product(rows_j(rows, hold, direction), hold, Of::of(hold));
  }
  return sum;
}

/// In `kCount` directions from one on.
template <class Of = OfVelocities, std::size_t kCount>
void push(std::size_t direction, const Rows& rows, const RowPoint& point,
          const std::array<double, kCount>& impulse) {
  // Points that carry nothing are most of them.
  if (std::all_of(impulse.begin(), impulse.end(), [](double x) { return x == 0; })) return;
  for (std::size_t i = 0; i < point.looses; ++i) {
    add(point.loose[i], direction, impulse, Of::of(point.loose[i]));
  }
  for (std::size_t i = 0; i < point.held; ++i) {
    const Hold& hold = point.holds[i];
    add(rows_w(rows, hold, direction), hold, impulse, Of::of(hold));
  }
}

/// Returns the change in velocity that was asked for.
double relax(RowPoint& point, const Rows& rows, double inverse_dt) {
  // The normal first, then friction within the new limit.
  const double change = next_push(point, along(kNormal, rows, point), inverse_dt);
  push(kNormal, rows, point, std::array{change});
  const double most = asked(change, point.mass[kNormal]);
  if (carries_nothing(point)) return most;
  const double mass = slide_mass(point);
  const double first = along(kFirst, rows, point), second = along(kSecond, rows, point);
  const std::array slide = next_slide(point, mass, first, second);
  push(kFirst, rows, point, slide);
  return std::max(most, asked(slide, mass));
}

// M⁻¹'s column is what an impulse on one axis does to all.
void turn(const SolverAxis& axis, SolverTask& task, double impulse) {
  if (impulse == 0) return;  // most stops are far away
  SolverMechanism& mechanism = task.mechanisms[axis.mechanism];
  const std::size_t n = mechanism.dofs;
  const double* w = mechanism.inverse + axis.dof * n;  // a row or a column: they are the same
  for (std::size_t i = 0; i < n; ++i) mechanism.v[i] += w[i] * impulse;
}

double relax_axis(SolverAxis& axis, SolverTask& task, double inverse_dt) {
  const SolverMechanism& mechanism = task.mechanisms[axis.mechanism];
  const double inverse = mechanism.inverse[axis.dof * mechanism.dofs + axis.dof];
  const double speed = mechanism.v[axis.dof];
  double impulse = 0;
  if (axis.side == 0) {
    // A motor, which pulls towards a speed with a force of so much at most.
    impulse = axis.impulse + (axis.target - speed) / inverse;
    impulse = std::clamp(impulse, -axis.most, axis.most);
  } else {
    // A stop, which pushes one way. One that was overrun is left by a tenth of the overlap in each
    // small step.
    const double least = -axis.gap * inverse_dt * (axis.gap > 0 ? 1 : kOverlapCorrection);
    impulse = axis.impulse + (axis.side * least - speed) / inverse;
    impulse = axis.side > 0 ? std::max(0.0, impulse) : std::min(0.0, impulse);
  }
  const double change = impulse - axis.impulse;
  axis.impulse = impulse;
  turn(axis, task, change);
  return std::abs(change) * inverse;
}

std::span<RowPoint> points_of(Rows& rows, const RowRun& run) {
  return {&rows.points[run.begin], run.end - run.begin};
}
std::span<const RowPoint> points_of(const Rows& rows, const RowRun& run) {
  return {&rows.points[run.begin], run.end - run.begin};
}

}  // namespace

void apply_last_rows(const Rows& rows, SolverTask& task) {
  for (const SolverAxis& axis : rows.axes) turn(axis, task, axis.impulse);
  for (const RowRun& run : rows.runs) {
    const std::span points = points_of(rows, run);
    const RowPoint& first = points[0];
    if (first.kind != RowKind::any) {
      apply_last_run(points, rows.numbers.data());
    } else {
      push(kNormal, rows, first, std::array{first.push, first.slide[0], first.slide[1]});
    }
  }
}

double sweep_rows(Rows& rows, SolverTask& task, double inverse_dt) {
  double change = 0;
  // Motors and stops before contacts, so that contacts have the last word.
  for (SolverAxis& axis : rows.axes) {
    change = std::max(change, relax_axis(axis, task, inverse_dt));
  }
  for (const RowRun& run : rows.runs) {
    const std::span points = points_of(rows, run);
    change = std::max(change, points[0].kind != RowKind::any
                                  ? relax_run(points, rows.numbers.data(), inverse_dt)
                                  : relax(points[0], rows, inverse_dt));
  }
  return change;
}

void follow_row_gaps(Rows& rows, const SolverTask& task, double dt) {
  for (SolverAxis& axis : rows.axes) {
    axis.gap += axis.side * task.mechanisms[axis.mechanism].v[axis.dof] * dt;
  }
  for (const RowRun& run : rows.runs) {
    const std::span points = points_of(rows, run);
    if (points[0].kind != RowKind::any) {
      follow_run_gaps(points, rows.numbers.data(), dt);
    } else {
      points[0].gap += along(kNormal, rows, points[0]) * dt;
    }
  }
}

bool overlapping(const Rows& rows) {
  return std::any_of(rows.points.begin(), rows.points.end(),
                     [](const RowPoint& point) { return point.shift_target > 0; });
}

void shift_rows(Rows& rows) {
  for (const RowRun& run : rows.runs) {
    const std::span points = points_of(rows, run);
    if (points[0].kind != RowKind::any) {
      shift_run(points, rows.numbers.data());
      continue;
    }
    const double change = next_shift(points[0], along<OfShifts>(kNormal, rows, points[0]));
    push<OfShifts>(kNormal, rows, points[0], std::array{change});
  }
}

void keep_row_impulses(const Rows& rows, SolverTask& task) {
  const double parts = task.small_steps;
  for (const RowPoint& from : rows.points) {
    ContactPoint& point = task.contacts[from.contact].points[from.point];
    point.push = from.push * parts;
    point.friction =
        (from.directions[kFirst] * from.slide[0] + from.directions[kSecond] * from.slide[1]) *
        parts;
  }
  for (std::size_t i = 0; i < rows.axes.size(); ++i) {
    task.axes[i].impulse = rows.axes[i].impulse * parts;
  }
}

}  // namespace stig::physics
