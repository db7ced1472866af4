// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::sensing {}
namespace stig::robots {}

namespace stig::physics {
using namespace sensing;
using namespace robots;
}  // namespace stig::physics
