// SPDX-License-Identifier: MIT
// The program speaks of every layer unqualified.
#pragma once

namespace stig::rules {}
namespace stig::lattice {}
namespace stig::certify {}
namespace stig::verify {}
namespace stig::synthesis {}
namespace stig::sensing {}
namespace stig::robots {}
namespace stig::lua {}
namespace stig::physics {}
namespace stig::compiler {}
namespace stig::assembly {}
namespace stig::validate {}
namespace stig::view {}

namespace stig::cli {
using namespace rules;
using namespace lattice;
using namespace certify;
using namespace verify;
using namespace synthesis;
using namespace sensing;
using namespace robots;
using namespace lua;
using namespace physics;
using namespace compiler;
using namespace assembly;
using namespace validate;
using namespace view;
}  // namespace stig::cli
