// SPDX-License-Identifier: MIT
// Tests, benchmarks and fuzz targets speak of every layer unqualified.
#pragma once

#include "assembly/uses.h"
#include "validate/uses.h"
#include "view/uses.h"

namespace stig {
using namespace assembly;
using namespace validate;
using namespace view;
}  // namespace stig
