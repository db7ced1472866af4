// SPDX-License-Identifier: MIT
// Rows of mechanisms with any number of degrees of freedom that a world takes: velocities stay at
// hand from point to point of a run. Where there are few degrees of freedom, each number of them
// is compiled for itself and keeps them in registers. Everything comes out to the bit as the rows
// of a single point (solver_rows.cpp) would have it.
#pragma once

#include "physical/solver/row_runs.h"

namespace stig::physics {

/// From a floating body alone to this number of them, each is compiled for itself.
inline constexpr std::uint32_t kMostWrittenOutDofs = 20;

/// The code for runs of points of one mechanism, against what stands or against a free body.
RunCode mechanism_code(std::uint32_t dofs, bool on_loose);

}  // namespace stig::physics
