// SPDX-License-Identifier: MIT
// Large targets that robots were to be able to build, by name, each in a bounded time: rules for
// them, or the reason why there are none.
#pragma once

#include "compiler/abilities.h"
#include "support/uses.h"

namespace stig::bench {

/// Prints a table and how time grows with bricks; false when a target took too long or, in that
/// time, neither rules nor a proof that there are none were found.
bool measure_named(const Abilities& robot, int kinds);

}  // namespace stig::bench
