// SPDX-License-Identifier: MIT
// A physical run as an animated binary glTF file: a node for each body, whose place and turn are
// interpolated between the moments that a page keeps too (pose_track.h).
#pragma once

#include <functional>
#include <string>

#include "base/rgb.h"
#include "physical/robots/led.h"
#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

/// The part of a run that is shown, in s of the run, and how many of these take a second.
struct PoseSpan {
  double from = 0, to = 0, speed = 1;
};

/// What of it is shown, and how: nothing given is all, in the colours of the LEDs.
struct PoseLook {
  std::function<bool(const Vec3& place)> shown;
  std::function<Rgb(Led led)> glow;
};

/// Metres, y up. What has not come, has left or is not shown is scaled to nothing. Materials do not
/// change in glTF: a block that shows several colours is as many surfaces, of which one is there at
/// a time.
std::string pose_glb(const PoseTrace& trace, const PoseSpan& span, const PoseLook& look = {});

}  // namespace stig::view
