// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "lattice/uses.h"
#include "physical/simulation/uses.h"

namespace stig::view {
using namespace lattice;
using namespace physics;
}  // namespace stig::view
