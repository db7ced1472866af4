// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "certify/uses.h"
#include "robots/uses.h"

namespace stig::recheck {
using namespace certify;
using namespace robots;
}  // namespace stig::recheck
