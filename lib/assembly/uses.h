// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::rules {}
namespace stig::lattice {}
namespace stig::certify {}
namespace stig::verify {}
namespace stig::synthesis {}
namespace stig::sensing {}
namespace stig::robots {}
namespace stig::compiler {}

namespace stig::assembly {
using namespace rules;
using namespace lattice;
using namespace certify;
using namespace verify;
using namespace synthesis;
using namespace sensing;
using namespace robots;
using namespace compiler;
}  // namespace stig::assembly
