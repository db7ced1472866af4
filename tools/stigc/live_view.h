// SPDX-License-Identifier: MIT
// stigc view --live: a run that is served to a browser while it goes on.
#pragma once

#include "app.h"
#include "uses.h"

namespace stig::cli {

/// Until it is interrupted, which is its end; an exit code.
int view_live(const ViewOptions& options, App& app);

}  // namespace stig::cli
