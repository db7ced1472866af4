// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "compiler/uses.h"
#include "physical/simulation/uses.h"

namespace stig::validate {
using namespace compiler;
using namespace physics;
}  // namespace stig::validate
