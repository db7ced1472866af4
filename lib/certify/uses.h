// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that its CMakeLists.txt says it
// uses.
#pragma once

namespace stig::rules {}

namespace stig::certify {
using namespace rules;
}  // namespace stig::certify
