// SPDX-License-Identifier: MIT
// The program speaks of every layer unqualified.
#pragma once

#include "assembly/uses.h"
#include "live/uses.h"
#include "urdf/uses.h"
#include "validate/uses.h"
#include "view/uses.h"

namespace stig::cli {
using namespace assembly;
using namespace live;
using namespace urdf;
using namespace validate;
using namespace view;
}  // namespace stig::cli
