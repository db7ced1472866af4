// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

namespace stig::sensing {}

namespace stig::robots {
using namespace sensing;
}  // namespace stig::robots
