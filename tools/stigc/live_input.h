// SPDX-License-Identifier: MIT
// What stigc view --live runs: a scene or a rule set, read anew whenever a file of it is saved.
#pragma once

#include "app.h"
#include "live/session.h"
#include "uses.h"

namespace stig::cli {

/// As the files are now. Problems are reported, and are the load's trouble as well.
LiveLoad load_live(const ViewOptions& options, const App& app);

}  // namespace stig::cli
