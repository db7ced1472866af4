// SPDX-License-Identifier: MIT
// Three of the messages that viewers of robots' data know by name
// (docs.foxglove.dev/docs/sdk/schemas), described as JSON Schema: poses of frames, things in a
// scene, and lines of a log. Their fields are those of version 2.1 of these messages, which a test
// compares.
#pragma once

#include <string>

#include "view/uses.h"

namespace stig::view {

std::string frame_transforms_schema();
std::string scene_update_schema();
std::string log_schema();

}  // namespace stig::view
