// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "physical/trace/pose_trace.h"
#include "physical/trace/uses.h"

namespace stig::physics {

/// Reads the text in which a trace's header says what was run, at which step and with which bodies
/// (docs/simulate.md). False when it is malformed; `header` is then of no use.
bool read_header_json(std::string_view text, PoseTraceHeader& header);

}  // namespace stig::physics
