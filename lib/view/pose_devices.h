// SPDX-License-Identifier: MIT
// What the robots and blocks of a physical run have, for pages: devices with their places,
// programs, magnets. It is read from the scene that the trace carries.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "physical/trace/pose_trace.h"
#include "view/uses.h"

namespace stig::view {

/// {"robots": [{"name", "root", "period", "program", "cameras", "ranges", "radios"}, …],
///  "programs": […], "magnets": [[model's places], …], "blocks": [magnets of each body or -1]}.
/// Bodies are numbers of the trace. Lists are empty where the scene cannot be read any more.
nlohmann::ordered_json devices_json(const PoseTrace& trace);

}  // namespace stig::view
