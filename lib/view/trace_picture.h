// SPDX-License-Identifier: MIT
// What a picture or a reading takes of a moment of a trace; of a run:
// physical/simulation/run_picture.h.
#pragma once

#include <vector>

#include "physical/render/scene_picture.h"
#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

/// Every body that has not left.
std::vector<PictureBody> picture_bodies(const PoseTrace& trace, const TraceFrame& frame);
/// The arrows that robots' programs show.
std::vector<PictureLine> picture_lines(const PoseTrace& trace, const TraceFrame& frame);
/// All bodies of the trace as they look at its end, at the origin.
std::vector<PictureBody> last_looks(const PoseTrace& trace);

}  // namespace stig::view
