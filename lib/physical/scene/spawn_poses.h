// SPDX-License-Identifier: MIT
// Where the blocks of an entry are. Private to this folder.
#pragma once

#include <vector>

#include "physical/scene/scene.h"

namespace stig::physics {

/// In the entry's frame, of blocks of that side. Of scattered blocks fewer than asked for when
/// there is no room for all.
std::vector<Pose> spawn_poses(const BlockSpawn& spawn, double side, std::uint64_t seed,
                              std::size_t entry);

}  // namespace stig::physics
