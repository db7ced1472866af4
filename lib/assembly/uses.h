// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "compiler/uses.h"
#include "synthesis/uses.h"

namespace stig::assembly {
using namespace compiler;
using namespace synthesis;
}  // namespace stig::assembly
