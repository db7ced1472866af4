// SPDX-License-Identifier: MIT
// Which body is painted before which, where there is no depth of pixels: in drawings of lines.
#pragma once

#include <vector>

#include "physical/render/scene_picture.h"
#include "physical/render/uses.h"

namespace stig::physics {

/// The bodies, each before all that may hide a part of it. That follows from planes that part two
/// bodies, which convex ones have unless they overlap: such, and those that hide each other in a
/// ring, stand in the order of their distances from the eye.
std::vector<PictureBody> painting_order(std::vector<PictureBody> bodies, const PictureView& view);

}  // namespace stig::physics
