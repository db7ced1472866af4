// SPDX-License-Identifier: MIT
// A physical scene that runs while somebody looks at it.
#pragma once

#include <memory>

#include "live/live_run.h"
#include "physical/simulation/loaded_scene.h"

namespace stig::live {

/// State: "bodies" of whole numbers (pose_trace.h has the quanta) and "leds" a body, "show",
/// "broken" (1 by hand, 2 its program has failed) and "robots" (x, y, z in m) a robot. News: [time,
/// body, "line"] of what programs said.
std::unique_ptr<LiveRun> pose_live(LoadedScene loaded);

}  // namespace stig::live
