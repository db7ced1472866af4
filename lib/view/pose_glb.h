// SPDX-License-Identifier: MIT
// A physical run as an animated binary glTF file: a node for each body, whose place and turn are
// interpolated between the moments that a page keeps too (pose_track.h).
#pragma once

#include <string>

#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

/// The part of a run that is shown, in s of the run, and how many of these take a second.
struct PoseSpan {
  double from = 0, to = 0, speed = 1;
};

/// Metres, y up. What has not come or has left is scaled to nothing. Materials do not change in
/// glTF: a block has the colour that its LEDs show at the end.
std::string pose_glb(const PoseTrace& trace, const PoseSpan& span);

}  // namespace stig::view
