// SPDX-License-Identifier: MIT
// Poses as a table: CSV with x, y, z in m and rz, ry, rx in degrees, a pose a line.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostic.h"
#include "base/vec.h"
#include "physical/scene/uses.h"

namespace stig::physics {

inline constexpr std::size_t kMostPoses = 20'000;

/// Rotation about z, then the new y, then the new x, each in degrees.
Quat turned(const Vec3& degrees_zyx);

/// Empty lines are passed over, those that begin with '#', and a first one that is no numbers:
/// it names the columns.
std::optional<std::vector<Pose>> read_poses_file(SourceRef source, Diagnostics& diagnostics);

}  // namespace stig::physics
