// SPDX-License-Identifier: MIT
// The paper's robot as its shipped file has it, for benchmarks.
#pragma once

#include "compiler/abilities.h"
#include "support/uses.h"

namespace stig::bench {

/// robots/bebot.yaml with blocks/stigmergic.yaml; ends the program if one cannot be read.
const Abilities& paper_robot();

}  // namespace stig::bench
