// SPDX-License-Identifier: MIT
// A physical run as a table, for programs that draw and reckon: a row for each body that can move
// and each moment at which the trace has it.
//
// Columns: time (s), body (its name), kind (block, or robot for the parts of robots), x y z (m, of
// the body's own frame in the world's), qw qx qy qz (its rotation as a unit quaternion, the world's
// axes from the body's), awake (1, or 0 for a body that rests). Rows are in the order of time, and
// of the scene within a moment. What has not come or has left has no row. As in RFC 4180, but lines
// end in a newline alone.
#pragma once

#include <functional>
#include <string_view>

#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

/// Hands the table over piece by piece, the head first. `sink` returns false to end it.
void write_pose_csv(const PoseTrace& trace, const std::function<bool(std::string_view)>& sink);

}  // namespace stig::view
