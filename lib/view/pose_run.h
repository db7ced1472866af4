// SPDX-License-Identifier: MIT
// Runs in the physical world, as pages show them.
#pragma once

#include <string>

#include "physical/trace/pose_trace.h"
#include "view/page.h"
#include "view/uses.h"

namespace stig::view {

/// Adds a trace: bodies with their shapes and tracks, lights, what robots show and say, and events
/// but for sleeping and waking.
void add_pose_run(const PoseTrace& trace, const std::string& name, PageContent& page);

}  // namespace stig::view
