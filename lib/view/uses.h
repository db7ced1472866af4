// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::rules {}
namespace stig::lattice {}
namespace stig::sensing {}
namespace stig::robots {}
namespace stig::lua {}
namespace stig::physics {}

namespace stig::view {
using namespace rules;
using namespace lattice;
using namespace sensing;
using namespace robots;
using namespace lua;
using namespace physics;
}  // namespace stig::view
