// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::rules {}
namespace stig::lattice {}
namespace stig::certify {}
namespace stig::verify {}
namespace stig::sensing {}
namespace stig::robots {}
namespace stig::lua {}
namespace stig::physics {}
namespace stig::compiler {}

namespace stig::validate {
using namespace rules;
using namespace lattice;
using namespace certify;
using namespace verify;
using namespace sensing;
using namespace robots;
using namespace lua;
using namespace physics;
using namespace compiler;
}  // namespace stig::validate
