// SPDX-License-Identifier: MIT
// A scene for many seeds, on all cores.
#pragma once

#include "app.h"
#include "physical/scene/scene.h"
#include "uses.h"

namespace stig::cli {

/// Runs the scene for `runs` seeds from the first on, prints a table or JSON; an exit code.
int simulate_runs(const SimulateOptions& options, const Scene& scene, App& app);

}  // namespace stig::cli
