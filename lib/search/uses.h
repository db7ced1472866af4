// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "verify/uses.h"

namespace stig::search {
using namespace verify;
}  // namespace stig::search
