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
/// What a block shows from a tick on.
struct LedChange {
  std::uint64_t tick = 0;
  Led led = Led::off;
};
/// Of each body: what it shows at a tick, and how that changes until another. Nothing but dark of
/// what is no block.
std::vector<std::vector<LedChange>> led_changes(const PoseTrace& trace, std::uint64_t first,
                                                std::uint64_t last);

}  // namespace stig::view
