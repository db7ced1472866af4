// SPDX-License-Identifier: MIT
// What a picture takes of a run as it stands.
#pragma once

#include <vector>

#include "physical/render/scene_picture.h"
#include "physical/simulation/simulation.h"
#include "physical/simulation/uses.h"

namespace stig::physics {

/// Every body that has not left.
std::vector<PictureBody> picture_bodies(const Simulation& run);
/// The arrows that robots' programs show.
std::vector<PictureLine> picture_lines(const Simulation& run);

}  // namespace stig::physics
