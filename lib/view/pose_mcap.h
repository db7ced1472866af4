// SPDX-License-Identifier: MIT
// A physical run as an MCAP file, for viewers of robots' data (mcap_file.h, foxglove_schema.h).
//
// Three topics. /tf has the poses of all bodies in the frame "world" at each recorded moment: a
// block, and each part of a robot, is a frame of its name. /scene has their shapes and colours, all
// of them whenever one comes, leaves or changes its light, so that any moment's last message is the
// whole. /log has what robots' programs log, what happened (touched, snapped, let go, rests,
// moves, left), and how the run ended.
#pragma once

#include <functional>
#include <string_view>

#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

/// Hands the file over piece by piece. `sink` returns false to end it.
void write_pose_mcap(const PoseTrace& trace, const std::function<bool(std::string_view)>& sink);

}  // namespace stig::view
