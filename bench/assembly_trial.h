// SPDX-License-Identifier: MIT
// One target, from its drawing to what robots make of it.
#pragma once

#include <string>

#include "assembly_rows.h"
#include "support/uses.h"

namespace stig::bench {

/// `stigc`: a program that builds what is compiled; empty: nothing is built. The rules go into the
/// folder, as KIND-SEED.yaml, and those for two robots, where they are others, as
/// KIND-SEED-two.yaml. May be called from several threads.
AssemblyRow try_target(const std::string& kind, std::uint64_t seed, const std::string& stigc,
                       const std::string& folder);

}  // namespace stig::bench
