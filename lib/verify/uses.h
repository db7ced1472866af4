// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "certify/uses.h"
#include "lattice/uses.h"

namespace stig::verify {
using namespace certify;
using namespace lattice;
}  // namespace stig::verify
