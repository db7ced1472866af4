// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::rules {}
namespace stig::lattice {}
namespace stig::certify {}

namespace stig::verify {
using namespace rules;
using namespace lattice;
using namespace certify;
}  // namespace stig::verify
