// SPDX-License-Identifier: MIT
// A scene's programs tried before it runs: each is loaded as it would be at the beginning of a
// run, in the same sandbox, and asked for the function by which it is called.
#pragma once

#include "base/diagnostic.h"
#include "physical/scene/scene.h"
#include "physical/scene/uses.h"

namespace stig::physics {

/// Reports, with S610 and S611, programs of robots, of blocks and of the experiment that are no
/// Lua, fail while they are loaded or in `init`, or define nothing that is called. A program that
/// robots of one kind have with several sets of parameters is tried with each, up to a number of
/// robots.
void check_programs(const Scene& scene, const PlacedScene& placed, Diagnostics& diagnostics);

}  // namespace stig::physics
