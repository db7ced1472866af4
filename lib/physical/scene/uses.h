// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "lua/uses.h"
#include "physical/robots/uses.h"

namespace stig::physics {
using namespace lua;
}  // namespace stig::physics
