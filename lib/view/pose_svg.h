// SPDX-License-Identifier: MIT
// A moment of a physical run as a drawing of polygons.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "physical/render/scene_picture.h"
#include "view/uses.h"

namespace stig::view {

/// As draw_bodies, without depth: bodies are painted from the farthest to the nearest, where they
/// overlap as wholes, and lines upon them all. With a caption in the lower left corner. Empty where
/// there are more than kMostSvgFaces polygons.
std::string pose_svg(const std::vector<PictureBody>& bodies, const PictureView& view,
                     const std::optional<PictureFloor>& floor,
                     const std::vector<PictureLine>& lines, const std::string& caption);

}  // namespace stig::view
