// SPDX-License-Identifier: MIT
// The frames of a trace one after the other, for whoever wants them all.
#pragma once

#include <functional>

#include "physical/trace/pose_trace.h"
#include "physical/trace/uses.h"

namespace stig::physics {

/// Calls `visit` for each frame of a trace that was read, in the order of their ticks.
void for_each_frame(const PoseTrace& trace, const std::function<void(const TraceFrame&)>& visit);

}  // namespace stig::physics
