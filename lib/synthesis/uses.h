// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::rules {}
namespace stig::lattice {}

namespace stig::synthesis {
using namespace rules;
using namespace lattice;
}  // namespace stig::synthesis
