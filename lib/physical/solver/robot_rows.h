// SPDX-License-Identifier: MIT
// Rows of points of one mechanism, and first of a robot with four wheels and a lift, of which a
// step has most: velocities stay in the
// processor's registers from point to point, where each waits for what the last one left.
// Everything comes out to the bit as the rows of any mechanism (solver_rows.cpp) would have it.
#pragma once

#include <cstdint>
#include <span>

#include "physical/solver/solver_rows.h"

namespace stig::physics {

/// Degrees of freedom of such a robot: a floating body, four wheels and a lift.
inline constexpr std::uint32_t kRobotDofs = 11;

/// The kind of a point that is otherwise made.
RowKind kind_of(const RowPoint& point);

// Each goes through a run of points, none of which is of any kind; `numbers` are those of Rows.
void apply_last_run(std::span<const RowPoint> run, const double* numbers);
double relax_run(std::span<RowPoint> run, const double* numbers, double inverse_dt);
void follow_run_gaps(std::span<RowPoint> run, const double* numbers, double dt);
void shift_run(std::span<RowPoint> run, const double* numbers);

}  // namespace stig::physics
