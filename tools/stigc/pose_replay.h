// SPDX-License-Identifier: MIT
// stigc replay for traces of simulate.
#pragma once

#include <string>

#include "app.h"
#include "uses.h"

namespace stig::cli {

/// `bytes` begin as a trace of poses does; an exit code.
int replay_poses(const ReplayOptions& options, std::string bytes, App& app);

}  // namespace stig::cli
