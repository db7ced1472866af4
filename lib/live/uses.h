// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "view/uses.h"

namespace stig::live {
using namespace view;
}  // namespace stig::live
