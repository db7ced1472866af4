// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "recheck/uses.h"
#include "robots/uses.h"
#include "verify/uses.h"

namespace stig::compiler {
using namespace recheck;
using namespace robots;
using namespace verify;
}  // namespace stig::compiler
