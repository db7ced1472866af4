// SPDX-License-Identifier: MIT
// The layers whose names this one speaks of unqualified: those that it uses, and those that
// these use.
#pragma once

#include "robots/uses.h"

namespace stig::urdf {
using namespace robots;
}  // namespace stig::urdf
